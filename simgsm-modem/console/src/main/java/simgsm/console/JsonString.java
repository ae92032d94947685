package simgsm.console;

import simgsm.file.LineText;

/** JSON strings (RFC 8259), for consoles and web pages. */
public final class JsonString {
    private JsonString() {}

    /** In double quotes on one line; control characters are escaped. */
    public static String quoted(String value) {
        return '"' + LineText.escaped(value.replace("\\", "\\\\").replace("\"", "\\\"")) + '"';
    }
}
