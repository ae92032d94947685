package simgsm.web;

import java.util.Locale;
import simgsm.console.JsonString;

/** Writes JSON (RFC 8259) field by field. */
public final class JsonText {
    private final StringBuilder text = new StringBuilder();
    private boolean first = true;

    /** Nothing yet. */
    public JsonText() {}

    /** Begins an array or object. */
    public JsonText open(char bracket) {
        separate();
        text.append(bracket);
        first = true;
        return this;
    }

    /** Ends an array or object. */
    public JsonText close(char bracket) {
        text.append(bracket);
        first = false;
        return this;
    }

    /** The name of the next value. */
    public JsonText name(String name) {
        value(name);
        text.append(':');
        first = true;
        return this;
    }

    public JsonText value(String value) {
        separate();
        text.append(JsonString.quoted(value));
        return this;
    }

    public JsonText value(boolean value) {
        separate();
        text.append(value);
        return this;
    }

    public JsonText value(long value) {
        separate();
        text.append(value);
        return this;
    }

    /** A number with the given number of decimals, without exponent and without minus zero. */
    public JsonText value(double value, int decimals) {
        separate();
        String number = String.format(Locale.ROOT, "%." + decimals + "f", value);
        text.append(number.matches("-0\\.?0*") ? number.substring(1) : number);
        return this;
    }

    private void separate() {
        if (!first) {
            text.append(',');
        }
        first = false;
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
