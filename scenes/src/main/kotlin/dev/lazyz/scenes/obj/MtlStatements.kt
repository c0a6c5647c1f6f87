package dev.lazyz.scenes.obj

/**
 * The statements of a material library that say colours and numbers, for `MtlReader`; texture statements are kept here
 * instead, because that parser takes the last word for the file's name.
 *
 * Where both `d` (opacity) and `Tr` (its opposite, not in the specification) are given, `d` counts.
 */
internal class MtlStatements(text: String) : StatementReader(text) {
    /** For each `newmtl` so far, its texture statements by keyword. */
    val maps = ArrayList<Map<String, MtlMap>>()

    /** The statement that was handed out last. */
    var statement = ""
        private set

    private var current = HashMap<String, MtlMap>()
    private var hasOpacity = false

    override fun prepare(keyword: String, statement: String): String? {
        if (keyword == "newmtl") {
            current = HashMap()
            maps.add(current)
            hasOpacity = false
        } else if (maps.isEmpty()) {
            return null
        }
        this.statement = statement
        return when (keyword) {
            // The parser knows the keyword in lower case only
            "newmtl" -> "newmtl" + statement.substring(keyword.length)
            "d" -> withoutComment(statement).also { hasOpacity = true }
            "tr" -> withoutComment(statement).takeUnless { hasOpacity }
            "kd", "ks", "ke", "ns", "illum" -> withoutComment(statement)
            "map_kd", "map_d" -> null.also { current[keyword] = MtlMap.parse(statement.substring(keyword.length)) }
            else -> null
        }
    }
}
