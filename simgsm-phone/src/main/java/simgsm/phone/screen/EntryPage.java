package simgsm.phone.screen;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.KeyIntent.Simple;

/** A page for keying in one line: a number, a code or a name. */
final class EntryPage extends TextEntryPage {
    /** The kind of text accepted. */
    enum Kind {
        /** A telephone number; the star key writes its plus sign. */
        NUMBER("+0123456789"),
        /** A number with the signs of service codes. */
        CODE("+0123456789*#"),
        /** A secret number, shown as stars, or a service code. */
        PIN("0123456789*#"),
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
    private boolean stands;

    /**
     * An empty line.
     *
     * @param softLeft text key of the left key's function
     * @param done called with the text keyed in, unless it is empty
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

    /** Makes the up and down arrows open the names. */
    EntryPage withNames(ContactPages pages) {
        names = Optional.of(() -> pages.pick(picked -> KeyIntent.after(() -> with(picked))));
        return this;
    }

    /** Makes the page stay until another replaces it: no key closes it. */
    EntryPage standing() {
        stands = true;
        return this;
    }

    String text() {
        return entry.text();
    }

    @Override
    Screen screen() {
        Optional<TextEntry.Mode> mode = kind == Kind.NAME ? Optional.of(entry.mode()) : Optional.empty();
        String shown = kind == Kind.PIN && !isCode() ? "*".repeat(entry.text().length()) : entry.text();
        return new Screen.Entry(title, shown, entry.caret(), entry.choices(), mode);
    }

    @Override
    SoftKeys softKeys() {
        return entry.text().isEmpty()
                ? new SoftKeys(names.isPresent() ? "soft.names" : "", stands ? "" : "soft.back")
                : new SoftKeys(softLeft, "soft.clear");
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        return switch (key) {
            case CALL -> kind == Kind.PIN && !text().isEmpty() ? new KeyIntent.DialText(text()) : finish(key);
            case SOFT_LEFT, OK, MESSAGE -> finish(key);
            case SOFT_RIGHT, CLEAR -> eraseOrClose();
            case LEFT -> KeyIntent.after(entry::left);
            case RIGHT -> KeyIntent.after(entry::right);
            case UP, DOWN -> openNames();
            case MENU -> KeyIntent.after(this::nextMode);
            default -> KeyIntent.after(() -> key.tone().ifPresent(tone -> key(tone, nowNanos)));
        };
    }

    private KeyIntent finish(PhoneKey key) {
        entry.commit();
        if (!entry.text().isEmpty()) {
            return done.apply(entry.text());
        }
        return key == PhoneKey.SOFT_LEFT ? openNames() : Simple.NOTHING;
    }

    private KeyIntent openNames() {
        return names.map(Supplier::get).orElseGet(() -> KeyIntent.after(this::nextMode));
    }

    private void nextMode() {
        if (kind == Kind.NAME) {
            entry.nextMode();
        }
    }

    private void key(DtmfKey tone, long nowNanos) {
        if (kind == Kind.NAME) {
            entry.tap(tone, nowNanos);
        } else {
            type(kind == Kind.NUMBER && tone.symbol() == '*' ? '+' : tone.symbol());
        }
    }

    @Override
    boolean type(char character) {
        boolean isPlusWithin = kind == Kind.NUMBER && character == '+' && entry.caret() > 0;
        boolean isStrayInPin =
                kind == Kind.PIN && !Character.isDigit(character) && !(text() + character).startsWith("*");
        if (kind.takes(character) && !isPlusWithin && !isStrayInPin) {
            entry.type(character);
        }
        return true;
    }

    /** The text of a page of kind PIN, else an empty one. */
    String secret() {
        return kind == Kind.PIN ? text() : "";
    }

    private boolean isCode() {
        return text().startsWith("*");
    }

    @Override
    boolean erase() {
        return super.erase() || stands;
    }
}
