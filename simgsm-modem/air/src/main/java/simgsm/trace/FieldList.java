package simgsm.trace;

import java.util.ArrayList;
import java.util.List;
import simgsm.trace.MessageText.Field;

/** The fields of a message so far. */
final class FieldList {
    private final List<Field> fields = new ArrayList<>();
    private final FieldTexts texts;

    FieldList(FieldTexts texts) {
        this.texts = texts;
    }

    FieldTexts texts() {
        return texts;
    }

    List<Field> fields() {
        return fields;
    }

    /** Adds a field. @param from index of its first octet in the message; @param to index after its last one */
    void add(String key, Object value, int from, int to) {
        addNamed(texts.of(key), texts.value(value), from, to);
    }

    /** Adds a field without octets. */
    void add(String key, Object value) {
        add(key, value, 0, 0);
    }

    /** Adds a field with the same name in all languages. */
    void addNamed(String name, String value, int from, int to) {
        fields.add(new Field(name, value, from, to));
    }
}
