"""Penalty contact: tracked nodes are kept from passing through segments (LS-DYNA: SURFA, SURFB). Read in this order:

kinds/NAME             a keyword *CONTACT_NAME and its properties
build, cards           each card -> its contact in the model
surface, sides         element faces -> segments and tracked nodes, with stiffness; ORIEN
thickness              thickness of shells in contact; the depth at which a segment releases a node
initial_penetration    nodes that begin behind the surface: IGNORE
contact, cycle         passes and sorts; one cycle: energy, tracking, detection, force
records, parameters    the data of kernels: nodes, segments, state of each contact
geometry, projection   shape functions; closest point
search, detection      candidate segments of a node; where contact begins
tracking               where the contact point moves, where contact ends; tracking_simd: several at a time
neighbours, ridge      the segment that takes over a node which crosses an edge, or a ridge
force, friction        spring, damper, Coulomb friction
kinematics, energy     relative motion, balance of moments; energy account
stable_step, limits    facts of the run; active_step: the step that the active contacts allow
supported              what is supported of the contact keywords; without_effect: fields that change no result
control_contact        what is supported of *CONTROL_CONTACT
"""
