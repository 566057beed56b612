"""What *CONTROL_TIMESTEP asks for beyond the elements' own steps, one request a file; the folder is the list."""
