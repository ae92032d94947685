package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.screen.ListPage.ListItem;
import simgsm.phone.screen.Screen.Note;
import simgsm.phone.store.Contacts;
import simgsm.phone.store.Contacts.NamedNumber;
import simgsm.sim.SimPhoneBook;

/** The names on the SIM: list, search, edit. */
final class ContactPages {
    private final PageStack stack;
    private final Contacts contacts;
    /** Writes a message to a number. */
    private Function<String, KeyIntent> writeTo = number -> Simple.NOTHING;

    ContactPages(PageStack stack, Contacts contacts) {
        this.stack = stack;
        this.contacts = contacts;
    }

    void setWriteTo(Function<String, KeyIntent> action) {
        writeTo = action;
    }

    /** All names, and an entry for a new one. */
    KeyIntent list() {
        ListPage page = new ListPage(stack, Words.of("menu.names"), false, () -> {
            List<ListItem> items = new ArrayList<>();
            items.add(ListItem.of("option.new_name", () -> edit(Optional.empty(), "", "")));
            contacts.all().forEach(contact -> items.add(item(contact)));
            return items;
        });
        return stack.open(contacts.all().isEmpty() ? page : page.selecting(1));
    }

    private ListItem item(NamedNumber contact) {
        return new ListItem(
                contact.place(),
                row(contact),
                () -> options(contact),
                Optional.of(() -> call(contact)),
                Optional.of(() -> options(contact)));
    }

    private static Screen.Row row(NamedNumber contact) {
        return new Screen.Row(
                Screen.Mark.NAME, Words.plain(contact.name()), Words.NONE, Optional.empty(), contact.number());
    }

    private KeyIntent call(NamedNumber contact) {
        stack.home();
        return new KeyIntent.DialText(contact.number());
    }

    private KeyIntent options(NamedNumber contact) {
        Optional<Integer> place = Optional.of(contact.place());
        return stack.open(ListPage.options(stack, Words.plain(contact.name()))
                .option(true, "option.call", () -> call(contact))
                .option(true, "option.message", () -> writeTo.apply(contact.number()))
                .option(true, "option.edit", () -> edit(place, contact.name(), contact.number()))
                .option(true, "option.delete", () -> ask(contact)));
    }

    private KeyIntent ask(NamedNumber contact) {
        return stack.open(TextPage.question(
                stack,
                Words.of("question.delete", contact.name()),
                () -> KeyIntent.after(() -> contacts.erase(contact))));
    }

    /** Selects one of the names. @param picked receives its number */
    KeyIntent pick(Function<String, KeyIntent> picked) {
        ListPage[] page = new ListPage[1];
        page[0] = new ListPage(
                stack,
                Words.of("menu.names"),
                false,
                () -> contacts.all().stream()
                        .map(contact -> new ListItem(
                                contact.place(),
                                row(contact),
                                () -> {
                                    stack.close(page[0]);
                                    return picked.apply(contact.number());
                                },
                                Optional.empty(),
                                Optional.empty()))
                        .toList());
        return stack.open(page[0]);
    }

    /** Saves a number under a name to be keyed in. */
    KeyIntent save(String number) {
        return edit(Optional.empty(), "", number);
    }

    private KeyIntent edit(Optional<Integer> place, String name, String number) {
        if (place.isEmpty() && contacts.isFull()) {
            return note(Note.Kind.SIM_FULL);
        }
        EntryPage[] pages = new EntryPage[2];
        pages[0] = new EntryPage(
                        stack,
                        Words.of("lcd.name"),
                        EntryPage.Kind.NAME,
                        SimPhoneBook.MOST_LETTERS,
                        "soft.ok",
                        keyed -> stack.open(pages[1]))
                .with(name);
        pages[1] = new EntryPage(
                        stack,
                        Words.of("lcd.number"),
                        EntryPage.Kind.CODE,
                        SimPhoneBook.MOST_DIGITS,
                        "soft.save",
                        keyed -> {
                            contacts.write(place, pages[0].text(), keyed);
                            stack.close(pages[1]);
                            stack.close(pages[0]);
                            return note(Note.Kind.SAVED);
                        })
                .with(number);
        return stack.open(pages[0]);
    }

    private KeyIntent note(Note.Kind kind) {
        return stack.open(new NotePage(stack, new Note(kind, "")));
    }
}
