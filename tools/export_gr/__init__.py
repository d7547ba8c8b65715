"""The parts of tools/export_gr.py."""
