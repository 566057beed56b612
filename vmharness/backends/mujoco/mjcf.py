"""The model as MJCF, the XML of MuJoCo: options, bodies, tendons, contacts, the velocities at t = 0 as a keyframe."""

from xml.etree import ElementTree

from vmharness.backends.mujoco.element import element
from vmharness.backends.mujoco.forces import add_contacts, add_tendons
from vmharness.backends.mujoco.model import Model
from vmharness.backends.mujoco.world import add_bodies

# Masses and moments of the deck as they are: MuJoCo can raise them to a bound, and derive them from shapes.
AS_GIVEN = {"inertiafromgeom": "false", "boundmass": "0", "boundinertia": "0", "balanceinertia": "false"}
SOLVER = {"cone": "elliptic", "tolerance": "1e-15", "iterations": "200"}
NOSLIP = {"noslip_iterations": "10", "noslip_tolerance": "1e-15"}


def document(model: Model, step: float) -> str:
    """The text of model.xml, for a run with the time `step`."""
    root = ElementTree.Element("mujoco", model="deck")
    element(root, "compiler", angle="radian", **AS_GIVEN)
    friction = any(contact.friction for contact in model.contacts)
    solver = SOLVER | (NOSLIP if friction else {})
    option = element(root, "option", integrator="RK4", timestep=step, gravity=model.gravity, **solver)
    element(option, "flag", energy="enable")
    velocities = add_bodies(model, element(root, "worldbody"))
    add_tendons(model, element(root, "tendon"))
    add_contacts(model, element(root, "contact"), step)
    if velocities:
        element(element(root, "keyframe"), "key", name="start", qvel=velocities)
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode") + "\n"
