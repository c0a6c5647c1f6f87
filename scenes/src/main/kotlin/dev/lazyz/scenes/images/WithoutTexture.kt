package dev.lazyz.scenes.images

import dev.lazyz.world.Material

/** Returns this material without its texture, for surfaces that have no texture coordinates. */
internal fun Material.withoutTexture(): Material = if (texture == null) {
    this
} else {
    Material(
        baseColor = baseColor,
        shading = shading,
        specular = specular,
        shininess = shininess,
        emission = emission,
        alphaMode = alphaMode,
        alphaCutoff = alphaCutoff,
        sides = sides,
        shader = shader,
        name = name,
    )
}
