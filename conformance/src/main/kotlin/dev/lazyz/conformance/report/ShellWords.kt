package dev.lazyz.conformance.report

/** Words of commands that a message or a report contains. Thread safe. */
public object ShellWords {
    /** What means something to a shell. */
    private const val SPECIAL = " \t\n\"'\\$&|;<>()*?[]{}!~#`"

    /** Returns [word] as it is typed in a POSIX shell: in quotes if it is empty or contains special characters. */
    @JvmStatic
    public fun quoted(word: String): String =
        if (word.isEmpty() || word.any { it in SPECIAL }) "'${word.replace("'", "'\\''")}'" else word
}
