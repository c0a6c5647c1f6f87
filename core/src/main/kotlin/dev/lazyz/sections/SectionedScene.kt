package dev.lazyz.sections

import dev.lazyz.world.Scene

/**
 * A scene that was cut, see [Section].
 *
 * @property scene what remains, with caps
 * @property warnings what could not be cut or capped, in words; empty if everything could
 */
public class SectionedScene internal constructor(public val scene: Scene, public val warnings: List<String>) {
    override fun toString(): String = "SectionedScene($scene, ${warnings.size} warnings)"
}
