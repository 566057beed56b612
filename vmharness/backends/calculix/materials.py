"""Materials of CalculiX: elastic, and plastic with linear hardening that is isotropic or kinematic."""

from vmharness.backends.calculix.model import Model, real
from vmharness.deck import Entry
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.mat.plastic_kinematic import MAT_PLASTIC_KINEMATIC
from vmharness.deck.rule import among, only
from vmharness.deck.support import supports

SUPPORTS = (
    supports(MAT_ELASTIC, da=only(0.0), db=only(0.0)),
    supports(MAT_PLASTIC_KINEMATIC, src=only(0.0), srp=only(0.0), fs=only(0.0), beta=among(0.0, 1.0)),
)
FAR = 10.0  # plastic strain at which the table of hardening ends


def of(model: Model, material: Entry, form: str = "MAT", factor: float = 1.0) -> str:
    """The name of the material in CalculiX, which is added once; the form BAR of an elastic one has PR = 0.

    The `factor` is of its moduli, density and yield stress.
    """
    name = f"{form}{material.mid}" + (f"X{factor:.6g}".replace(".", "P") if factor != 1.0 else "")
    if name not in model.materials:
        plastic = material.keyword is MAT_PLASTIC_KINEMATIC
        pr = 0.0 if form == "BAR" and not plastic else material.pr
        model.materials[name] = [
            f"*MATERIAL,NAME={name}",
            "*ELASTIC",
            f"{real(factor * material.e)},{real(pr)}",
            "*DENSITY",
            real(factor * material.ro),
            *(_hardening(material, factor) if plastic else []),
        ]
    return name


def _hardening(material: Entry, factor: float) -> list[str]:
    """Yield stress over plastic strain, of the slope H = E ET/(E - ET)."""
    h = material.e * material.etan / (material.e - material.etan)
    kind = "ISOTROPIC" if material.beta else "KINEMATIC"
    return [
        f"*PLASTIC,HARDENING={kind}",
        f"{real(factor * material.sigy)},0.",
        f"{real(factor * (material.sigy + h * FAR))},{real(FAR)}",
    ]
