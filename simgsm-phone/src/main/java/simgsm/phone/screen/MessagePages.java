package simgsm.phone.screen;

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
        int most = Msisdn.MAX_DIGITS + 1;
        receiver = new EntryPage(stack, Words.of("lcd.to"), EntryPage.Kind.NUMBER, most, "soft.send", this::send)
                .with(number)
                .withNames(names);
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

    /** Opens the options of a message. @param view of the message, closed if it is erased; null in the list */
    KeyIntent options(MessageFolder folder, StoredMessage message, MessagePage view) {
        boolean isParty = folder != MessageFolder.BROADCASTS && isNumber(message.party());
        boolean isDraft = folder == MessageFolder.DRAFTS;
        return stack.open(ListPage.options(stack, Words.of("soft.options"))
                .option(isFailed(message), "option.again", () -> sendAgain(message))
                .option(isDraft, "option.edit", () -> edit(message))
                .option(folder == MessageFolder.INBOX && isParty, "option.reply", () -> answer(folder, message))
                .option(!isDraft, "option.forward", () -> begin("", message.text()))
                .option(isParty, "option.call", () -> call(folder, message))
                .option(isParty, "option.save", () -> names.save(message.party()))
                .option(true, "option.delete", () -> {
                    mailbox.remove(folder, message);
                    return view == null ? Simple.NOTHING : stack.close(view);
                })
                .option(true, "option.delete_all", () -> askToErase(folder)));
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

    /** Begins a text to a number; another unfinished text becomes a draft. */
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

    /** Asks for the receiver of the written text. */
    KeyIntent chooseReceiver() {
        entry.commit();
        return stack.open(receiver);
    }

    private KeyIntent send(String number) {
        return isNumber(number)
                ? new KeyIntent.SendText(Msisdn.parse(number), entry.text(), Optional.empty())
                : stack.open(new NotePage(stack, new Note(Note.Kind.NOT_A_NUMBER, number)));
    }

    /** Shows the progress of a message in the outbox, which replaces a failed message or the written text. */
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
