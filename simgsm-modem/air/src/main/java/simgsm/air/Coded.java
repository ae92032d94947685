package simgsm.air;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import simgsm.event.EventValue;

/** A field's value with a code on the wire. */
public interface Coded extends EventValue {
    /** The value on the wire. */
    int code();

    /** The code. */
    @Override
    default Object eventValue() {
        return code();
    }

    /** The value with this code, if there is one. */
    static <V extends Coded> Optional<V> find(V[] values, int code) {
        return Arrays.stream(values).filter(value -> value.code() == code).findFirst();
    }

    /** A value whose title is its name in the standard. */
    interface Titled extends Coded {
        /** A row of the standard's table. */
        record Row(int code, String title) {}

        Row row();

        @Override
        default int code() {
            return row().code();
        }

        default String title() {
            return row().title();
        }

        /** The constant. */
        String name();

        /** The title in Spanish; in English for any other language, and if there is no translation. */
        default String title(Locale language) {
            return CodeTitles.of(this, language);
        }
    }
}
