package simgsm.phone.screen;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import simgsm.phone.screen.KeyIntent.Simple;

/** A line to key in: a number, a code or a name. */
final class EntryPage extends TextEntryPage {
    /** What may be keyed. */
    enum Kind {
        /** A telephone number; the star key writes its plus sign. */
        NUMBER("+0123456789"),
        /** A number with the signs of service codes. */
        CODE("+0123456789*#"),
        /** Any text. */
        NAME("");

        private final String signs;

        Kind(String signs) {
            this.signs = signs;
        }

        private boolean takes(char sign) {
            return this == NAME || signs.indexOf(sign) >= 0;
        }
    }

    private final Words title;
    private final Kind kind;
    private final String softLeft;
    private final Function<String, KeyIntent> done;
    private Optional<Supplier<KeyIntent>> names = Optional.empty();

    /**
     * An empty line.
     *
     * @param softLeft what the left key does, a key of the bundle
     * @param done called with what was keyed, unless it is empty
     */
    EntryPage(PageStack stack, Words title, Kind kind, int most, String softLeft, Function<String, KeyIntent> done) {
        super(stack, new TextEntry(most));
        this.title = title;
        this.kind = kind;
        this.softLeft = softLeft;
        this.done = done;
        entry.setMode(kind == Kind.NAME ? TextEntry.Mode.CAPITAL : TextEntry.Mode.NUMBERS);
    }

    EntryPage with(String text) {
        entry.set(text);
        return this;
    }

    /** Opens the names by the arrows up and down. */
    EntryPage withNames(Supplier<KeyIntent> open) {
        names = Optional.of(open);
        return this;
    }

    String text() {
        return entry.text();
    }

    @Override
    Screen screen() {
        Optional<TextEntry.Mode> mode = kind == Kind.NAME ? Optional.of(entry.mode()) : Optional.empty();
        return new Screen.Entry(title, entry.text(), entry.caret(), entry.choices(), mode);
    }

    @Override
    SoftKeys softKeys() {
        return entry.text().isEmpty()
                ? new SoftKeys(names.isPresent() ? "soft.names" : "", "soft.back")
                : new SoftKeys(softLeft, "soft.clear");
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        switch (key) {
            case SOFT_LEFT, OK, CALL, MESSAGE -> {
                entry.commit();
                if (!entry.text().isEmpty()) {
                    return done.apply(entry.text());
                }
                return key == PhoneKey.SOFT_LEFT ? openNames() : Simple.NOTHING;
            }
            case SOFT_RIGHT, CLEAR -> {
                return erase() ? Simple.NOTHING : stack.close(this);
            }
            case LEFT -> entry.left();
            case RIGHT -> entry.right();
            case UP, DOWN -> {
                return openNames();
            }
            case MENU -> nextMode();
            default -> key.tone().ifPresent(tone -> key(tone.symbol(), key, nowNanos));
        }
        return Simple.NOTHING;
    }

    private KeyIntent openNames() {
        if (names.isPresent()) {
            return names.get().get();
        }
        nextMode();
        return Simple.NOTHING;
    }

    private void nextMode() {
        if (kind == Kind.NAME) {
            entry.nextMode();
        }
    }

    private void key(char symbol, PhoneKey key, long nowNanos) {
        if (kind == Kind.NAME) {
            entry.tap(key.tone().orElseThrow(), nowNanos);
        } else {
            type(kind == Kind.NUMBER && symbol == '*' ? '+' : symbol);
        }
    }

    @Override
    boolean type(char character) {
        boolean isPlusWithin = kind == Kind.NUMBER && character == '+' && entry.caret() > 0;
        if (kind.takes(character) && !isPlusWithin) {
            entry.type(character);
        }
        return true;
    }
}
