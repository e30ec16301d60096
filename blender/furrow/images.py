"""Converts between images in Blender and encoded image files."""

import os
import tempfile

import bpy

from .format.container import ImageFile, mime_type_of
from .format.reader import FurrowError


def image_from_file(file, is_data=True):
    """
    Create an image from an ImageFile. Raises FurrowError if Blender cannot decode it.

    The bytes of the file are packed into the image. If the user does not change the image, these bytes are exported.
    """
    image = bpy.data.images.new(file.name, 1, 1)
    image.pack(data=file.data, data_len=len(file.data))
    image.source = "FILE"
    image.alpha_mode = "CHANNEL_PACKED"
    image.colorspace_settings.is_data = is_data
    if min(image.size) == 0:
        bpy.data.images.remove(image)
        raise FurrowError(f"{file.name}: invalid image, which Blender cannot decode; export the face again")
    return image


def file_from_image(image):
    """
    Encode an image for glTF as an ImageFile. Unchanged images keep their original bytes.

    Raises FurrowError if the image has no pixels.
    """
    data = None if image.is_dirty else _stored(image)
    try:
        return ImageFile(image.name, mime_type_of(data or b""), data)
    except ValueError:
        return ImageFile(image.name, "image/png", _as_png(image))


def _stored(image):
    if image.packed_file:
        return image.packed_file.data
    path = bpy.path.abspath(image.filepath, library=image.library)
    if image.source == "FILE" and os.path.isfile(path):
        with open(path, "rb") as file:
            return file.read()
    return None


def _as_png(image):
    if not image.has_data and not image.packed_file and min(image.size) == 0:
        raise FurrowError(f'Furrow: image "{image.name}" has no pixels; load or bake it again')
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "image.png")
        # Saves a copy, because saving changes the path and the format of an image.
        copy = image.copy()
        try:
            if copy.size[0] == 0 or image.is_dirty or image.source == "GENERATED":
                copy = _same_pixels(image, copy)
            copy.file_format = "PNG"
            copy.filepath_raw = path
            copy.save()
        finally:
            bpy.data.images.remove(copy)
        with open(path, "rb") as file:
            return file.read()


def _same_pixels(image, copy):
    """Replace `copy` by a new image with the pixels of `image`, because `Image.copy` omits unsaved pixels."""
    import numpy as np

    name, is_float = image.name, image.is_float
    bpy.data.images.remove(copy)
    copy = bpy.data.images.new(name, *image.size, alpha=image.channels == 4, float_buffer=is_float)
    copy.colorspace_settings.name = image.colorspace_settings.name
    pixels = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(pixels)
    if len(copy.pixels) != len(pixels):
        raise FurrowError(f'Furrow: image "{image.name}" has {image.channels} channels; save it as PNG first')
    copy.pixels.foreach_set(pixels)
    return copy
