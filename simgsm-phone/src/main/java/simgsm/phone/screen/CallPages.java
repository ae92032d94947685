package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.screen.ListPage.ListItem;
import simgsm.phone.store.CallLog;
import simgsm.phone.store.CallRecord;
import simgsm.phone.store.Contacts;

/** The log of calls. */
final class CallPages {
    private final PageStack stack;
    private final CallLog log;
    private final Contacts contacts;
    private final ContactPages names;
    private final MessagePages messages;

    CallPages(PageStack stack, CallLog log, Contacts contacts, ContactPages names, MessagePages messages) {
        this.stack = stack;
        this.log = log;
        this.contacts = contacts;
        this.names = names;
        this.messages = messages;
    }

    KeyIntent menu() {
        return stack.open(ListPage.menu(
                stack,
                "menu.calls",
                () -> List.of(
                        kind(CallRecord.Kind.MISSED),
                        kind(CallRecord.Kind.RECEIVED),
                        kind(CallRecord.Kind.DIALLED),
                        ListItem.of("option.clear_log", this::ask))));
    }

    private ListItem kind(CallRecord.Kind kind) {
        Words count = Words.plain(String.valueOf(log.newest(kind).size()));
        return ListItem.of(Screen.Row.of(title(kind), count), () -> open(kind));
    }

    private static Words title(CallRecord.Kind kind) {
        return Words.of("calls." + kind.name().toLowerCase(Locale.ROOT));
    }

    private KeyIntent ask() {
        return stack.open(TextPage.question(stack, Words.of("question.clear_log"), () -> KeyIntent.after(log::clear)));
    }

    /** The calls of a kind, newest first. */
    KeyIntent open(CallRecord.Kind kind) {
        if (kind == CallRecord.Kind.MISSED) {
            log.missedSeen();
        }
        return stack.open(new ListPage(
                stack,
                title(kind),
                false,
                () -> log.newest(kind).stream().map(this::item).toList()));
    }

    private ListItem item(CallRecord record) {
        Screen.Row row = new Screen.Row(
                switch (record.kind()) {
                    case DIALLED -> Screen.Mark.DIALLED;
                    case RECEIVED -> Screen.Mark.RECEIVED;
                    case MISSED -> Screen.Mark.MISSED;
                },
                party(record),
                Words.NONE,
                Optional.of(record.at()),
                "");
        return new ListItem(
                record,
                row,
                () -> details(record),
                Optional.of(() -> call(record)),
                Optional.of(() -> options(record)));
    }

    private Words party(CallRecord record) {
        return record.number().isEmpty() ? Words.of("lcd.unknown") : Words.plain(contacts.nameOf(record.number()));
    }

    private KeyIntent call(CallRecord record) {
        if (record.number().isEmpty()) {
            return Simple.NOTHING;
        }
        stack.home();
        return new KeyIntent.DialText(record.number());
    }

    private KeyIntent details(CallRecord record) {
        return stack.open(TextPage.of(stack, title(record.kind()), () -> {
            List<Words> lines = new ArrayList<>(List.of(party(record)));
            if (!contacts.nameOf(record.number()).equals(record.number())) {
                lines.add(Words.plain(record.number()));
            }
            lines.add(Words.of("calls.at", record.at()));
            lines.add(Words.of("calls.duration", CallRecord.duration(record.seconds())));
            return lines;
        }));
    }

    private KeyIntent options(CallRecord record) {
        boolean isKnown = !record.number().isEmpty();
        return stack.open(ListPage.options(stack, Words.of("soft.options"))
                .option(isKnown, "option.call", () -> call(record))
                .option(isKnown, "option.message", () -> messages.writeTo(record.number()))
                .option(isKnown, "option.save", () -> names.save(record.number()))
                .option(true, "option.details", () -> details(record))
                .option(true, "option.delete", () -> KeyIntent.after(() -> log.remove(record))));
    }
}
