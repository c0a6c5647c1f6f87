package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.split
import com.github.ajalt.clikt.parameters.options.transformAll
import dev.lazyz.cli.strategies.Strategies

/** The help text of INPUT. */
internal const val INPUT_HELP: String =
    "A model (.obj, .stl, .ply, .off, .3mf, .gltf, .glb), a scene file (.json), the name of a built-in scene " +
        "(see 'zcli scenes'), or - for standard input"

/** The option `--classpath`. */
internal fun ParameterHolder.classPath() = option(
    "--classpath",
    metavar = "JAR",
    help = "Also load strategies from here: a jar with an entry META-INF/services/dev.lazyz.Renderer, or a jar " +
        "that it needs; repeat the option for more",
).multiple()

/** The option `--strategy` of commands that compare strategies. */
internal fun ParameterHolder.comparedStrategies() = severalStrategies(
    "Compare this strategy; for more, separate ids by commas, or repeat the option; all others are compared with " +
        "the first; default: all of 'zcli strategies'",
)

/** An option `--strategy` for several, separated by commas or repeated. */
internal fun ParameterHolder.severalStrategies(help: String) = option(
    "--strategy",
    metavar = "ID",
    help = help,
    completionCandidates = Completions.lists { Strategies.ids() },
).split(",").transformAll { it.flatten() }
