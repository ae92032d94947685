package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.screen.ListPage.ListItem;
import simgsm.phone.screen.Screen.Note;
import simgsm.phone.store.Contacts;
import simgsm.phone.store.Mailbox;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;
import simgsm.phone.store.StoredMessage.Delivery;

/** The message menu: folders, reading, writing, answering, forwarding. */
final class MessagePages {
    private final PageStack stack;
    private final Mailbox mailbox;
    private final Contacts contacts;
    private final ContactPages names;
    private final TextEntry entry = new TextEntry();
    private EntryPage receiver;

    MessagePages(PageStack stack, Mailbox mailbox, Contacts contacts, ContactPages names) {
        this.stack = stack;
        this.mailbox = mailbox;
        this.contacts = contacts;
        this.names = names;
        setReceiver("");
    }

    private void setReceiver(String number) {
        EntryPage page = new EntryPage(
                        stack,
                        Words.of("lcd.to"),
                        EntryPage.Kind.NUMBER,
                        Msisdn.MAX_DIGITS + 1,
                        "soft.send",
                        this::send)
                .with(number);
        receiver = page.withNames(() -> names.pick(picked -> {
            page.with(picked);
            return Simple.NOTHING;
        }));
    }

    KeyIntent menu() {
        return stack.open(ListPage.menu(
                stack,
                "menu.messages",
                () -> List.of(
                        ListItem.of("menu.write", this::write),
                        folder(MessageFolder.INBOX),
                        folder(MessageFolder.OUTBOX),
                        folder(MessageFolder.DRAFTS),
                        folder(MessageFolder.BROADCASTS))));
    }

    private ListItem folder(MessageFolder folder) {
        int unread = mailbox.unread(folder);
        int all = mailbox.in(folder).size();
        Words count = Words.plain(unread > 0 ? unread + "/" + all : String.valueOf(all));
        return ListItem.of(Screen.Row.of(title(folder), count), () -> open(folder));
    }

    private static Words title(MessageFolder folder) {
        return Words.of("menu." + folder.name().toLowerCase(Locale.ROOT));
    }

    KeyIntent open(MessageFolder folder) {
        return stack.open(new ListPage(
                stack,
                title(folder),
                false,
                () -> mailbox.newest(folder).stream()
                        .map(message -> item(folder, message))
                        .toList()));
    }

    private ListItem item(MessageFolder folder, StoredMessage message) {
        return new ListItem(
                message.serial(),
                new Screen.Row(
                        Screen.Mark.of(message),
                        message.party().isEmpty()
                                ? Words.of("lcd.no_receiver")
                                : Words.plain(contacts.nameOf(message.party())),
                        Words.NONE,
                        Optional.of(message.at()),
                        message.text().replace('\n', ' ')),
                () -> folder == MessageFolder.DRAFTS ? edit(message) : view(folder, message),
                Optional.of(() -> call(folder, message)),
                Optional.of(() -> options(folder, message, null)));
    }

    private KeyIntent view(MessageFolder folder, StoredMessage message) {
        return stack.open(new MessagePage(stack, mailbox, this, folder, message));
    }

    /** What can be done with a message. @param view of the message, closed when it is erased; null in the list */
    KeyIntent options(MessageFolder folder, StoredMessage message, MessagePage view) {
        List<ListItem> items = new ArrayList<>();
        ListPage page = ListPage.menu(stack, "soft.options", () -> items);
        boolean isParty = folder != MessageFolder.BROADCASTS && isNumber(message.party());
        if (isFailed(message)) {
            items.add(page.closing("option.again", () -> sendAgain(message)));
        }
        if (folder == MessageFolder.DRAFTS) {
            items.add(page.closing("option.edit", () -> edit(message)));
        }
        if (folder == MessageFolder.INBOX && isParty) {
            items.add(page.closing("option.reply", () -> answer(folder, message)));
        }
        if (folder != MessageFolder.DRAFTS) {
            items.add(page.closing("option.forward", () -> forward(message)));
        }
        if (isParty) {
            items.add(page.closing("option.call", () -> call(folder, message)));
            items.add(page.closing("option.save", () -> names.save(message.party())));
        }
        items.add(page.closing("option.delete", () -> {
            mailbox.remove(folder, message);
            return view == null ? Simple.NOTHING : stack.close(view);
        }));
        items.add(page.closing("option.delete_all", () -> askToErase(folder)));
        return stack.open(page);
    }

    private KeyIntent askToErase(MessageFolder folder) {
        return stack.open(TextPage.question(stack, Words.of("question.delete_all", title(folder)), () -> {
            mailbox.clear(folder);
            stack.home();
            return menu();
        }));
    }

    /** Continues the text, or begins one. */
    KeyIntent write() {
        return stack.open(new WritingPage(stack, entry, this));
    }

    /** Begins a text to a number; another text that was begun becomes a draft. */
    KeyIntent writeTo(String number) {
        return begin(number, "");
    }

    private KeyIntent begin(String number, String text) {
        keepText();
        setReceiver(number);
        entry.set(text);
        return write();
    }

    private void keepText() {
        if (!entry.text().isEmpty()) {
            mailbox.keepDraft(receiver.text(), entry.text());
        }
        entry.clear();
    }

    /** Moves the text to the drafts. */
    KeyIntent keepDraft() {
        keepText();
        setReceiver("");
        return stack.open(new NotePage(stack, new Note(Note.Kind.SAVED, "")));
    }

    private KeyIntent edit(StoredMessage draft) {
        mailbox.remove(MessageFolder.DRAFTS, draft);
        return begin(draft.party(), draft.text());
    }

    private KeyIntent forward(StoredMessage message) {
        return begin("", message.text());
    }

    /** Calls the sender or receiver of a message; a broadcast has none. */
    KeyIntent call(MessageFolder folder, StoredMessage message) {
        if (folder == MessageFolder.BROADCASTS || message.party().isEmpty()) {
            return Simple.NOTHING;
        }
        stack.home();
        return new KeyIntent.DialText(message.party());
    }

    KeyIntent answer(MessageFolder folder, StoredMessage message) {
        if (isFailed(message)) {
            return sendAgain(message);
        }
        return folder == MessageFolder.BROADCASTS
                ? Simple.NOTHING
                : writeTo(isNumber(message.party()) ? message.party() : "");
    }

    private static boolean isFailed(StoredMessage message) {
        return message.delivery() == Delivery.FAILED;
    }

    static KeyIntent sendAgain(StoredMessage failed) {
        return new KeyIntent.SendText(Msisdn.parse(failed.party()), failed.text(), Optional.of(failed));
    }

    /** The text is written: to whom does it go? */
    KeyIntent chooseReceiver() {
        entry.commit();
        return stack.open(receiver);
    }

    private KeyIntent send(String number) {
        return isNumber(number)
                ? new KeyIntent.SendText(Msisdn.parse(number), entry.text(), Optional.empty())
                : stack.open(new NotePage(stack, new Note(Note.Kind.NOT_A_NUMBER, number)));
    }

    /** The text is in the outbox: shows its progress. It takes the place of a failed message, or was being written. */
    void submitted(KeyIntent.SendText sent) {
        sent.replaced().ifPresent(failed -> mailbox.remove(MessageFolder.OUTBOX, failed));
        stack.home();
        stack.open(new SentPage(
                stack, mailbox, this, mailbox.newest(MessageFolder.OUTBOX).get(0)));
        if (sent.replaced().isEmpty()) {
            entry.clear();
            setReceiver("");
        }
    }

    static boolean isNumber(String text) {
        return text.matches("\\+?[0-9]{1," + Msisdn.MAX_DIGITS + "}");
    }
}
