package dev.lazyz.cli.options

import com.github.ajalt.clikt.completion.CompletionCandidates
import com.github.ajalt.clikt.completion.CompletionCandidates.Custom.ShellType
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.ParameterValues
import dev.lazyz.scenes.pictures.WordCompletion

/** What shells offer for values that are not just one of a few words. Words are only computed for their scripts. */
internal object Completions {
    /** What completes a value of [values]. */
    fun of(values: ParameterValues<*>): CompletionCandidates? = when (values.completion) {
        WordCompletion.NONE -> null
        WordCompletion.CHOICE -> CompletionCandidates.Fixed(values.words.toSet())
        WordCompletion.NAME -> words { values.words }
        WordCompletion.NAMES -> lists { values.words }
        WordCompletion.FILE -> CompletionCandidates.Path
    }

    /** One of [words]. */
    fun words(words: () -> Collection<String>) = CompletionCandidates.Custom { shell ->
        val all = words().joinToString(" ")
        if (shell == ShellType.FISH) "\"$all\"" else """COMPREPLY=(${'$'}(compgen -W '$all' -- "${'$'}{word}"))"""
    }

    /** Some of [words], separated by commas. */
    fun lists(words: () -> Collection<String>) = lists(words, "", "")

    /** Some of [words], separated by commas, and `=`, which something follows. */
    fun names(words: () -> Collection<String>) = lists(words, "=", "compopt -o nospace 2>/dev/null\n")

    private fun lists(words: () -> Collection<String>, end: String, setting: String) =
        CompletionCandidates.Custom { shell ->
            val all = words().joinToString(" ") { it + end }
            if (shell == ShellType.FISH) {
                "\"$all\""
            } else {
                """
                ${setting}local head=''
                [[ "${'$'}{word}" == *,* ]] && head="${'$'}{word%,*},"
                COMPREPLY=(${'$'}(compgen -P "${'$'}{head}" -W '$all' -- "${'$'}{word##*,}"))
                """.trimIndent()
            }
        }

    /** Files, folders and built-in scenes. */
    val inputs: CompletionCandidates = CompletionCandidates.Custom { shell ->
        val scenes = Scenes.builtins.joinToString(" ") { it.id }
        if (shell == ShellType.FISH) {
            "\"$scenes\" -F"
        } else {
            """
            __complete_files "${'$'}{word}"
            COMPREPLY+=(${'$'}(compgen -W '$scenes' -- "${'$'}{word}"))
            """.trimIndent()
        }
    }
}
