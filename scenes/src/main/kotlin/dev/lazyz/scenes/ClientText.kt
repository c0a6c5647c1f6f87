package dev.lazyz.scenes

/**
 * Messages of the library in a form for clients of a server: without advice for those who run it, and not too long.
 * `lazyz-server` and `lazyz-mcp` use it.
 */
public object ClientText {
    /** Characters of a warning, at most. */
    public const val LONGEST: Int = 300

    private const val GAP = " ... "

    /** What the advice for operators and programmers has in it: settings and programs that a client does not have. */
    private val foreign = listOf("LoadLimits", "LoadOptions", "-Xmx", "zcli")

    /** Returns [text] without clauses that are for others, and with a gap in the middle if it is too long. */
    @JvmStatic
    public fun of(text: String): String {
        val clauses = text.split("; ")
        val own = clauses.filterNot { clause -> foreign.any { it in clause } }
        return shortened((own.ifEmpty { clauses.take(1) }).joinToString("; "))
    }

    /** Returns the message of [invalid]. Where it exceeds a limit, the client learns that the server has it. */
    @JvmStatic
    public fun of(invalid: SceneFormatException): String {
        val text = of(invalid.message.orEmpty())
        val isLimit = foreign.any { it in invalid.remedy.orEmpty() }
        return if (isLimit) "$text; that is a limit of this server: send a simpler model" else text
    }

    private fun shortened(text: String): String {
        if (text.length <= LONGEST) return text
        val end = LONGEST / 3
        return text.take(LONGEST - end - GAP.length) + GAP + text.takeLast(end)
    }
}
