package simrobot.http;

import java.util.Locale;

/** Text and numbers as they may stand in a page. */
final class Html {
    private Html() {}

    static String text(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;")
                .replace("'", "&#39;");
    }

    /** As short as can be at this many decimals. */
    static String number(double value, int decimals) {
        String fixed = String.format(Locale.ROOT, "%." + decimals + "f", value);
        return fixed.matches("-0(\\.0+)?") ? fixed.substring(1) : fixed;
    }
}
