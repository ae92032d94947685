package simgsm.phone.handset;

import java.util.List;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.Screen.Note;
import simgsm.phone.handset.StoredMessage.Delivery;

/** The way through menu, lists, messages and writing; everything but the home screen's number and call. */
final class Screens {
    /** What the screens have done by the phone. */
    interface Deeds {
        void dial(String number);

        /** @return whether it was handed in */
        boolean send(Msisdn to, String text);

        void switchOff();
    }

    private static final Screen HOME = new Screen.Home();
    private static final MenuItem[] MENU = MenuItem.values();

    private final Mailbox mailbox;
    private final Deeds deeds;
    private final TextEntry entry = new TextEntry();
    private String recipient = "";
    private Screen current = HOME;

    Screens(Mailbox mailbox, Deeds deeds) {
        this.mailbox = mailbox;
        this.deeds = deeds;
    }

    /** The screen as it is now. */
    Screen current() {
        if (current instanceof Screen.Sent sent) {
            return mailbox.own(sent.message().id())
                    .<Screen>map(Screen.Sent::new)
                    .orElse(HOME);
        }
        return current instanceof Screen.Writing ? writing() : current;
    }

    private Screen.Writing writing() {
        return new Screen.Writing(entry.text(), entry.isPending(), entry.choices(), entry.mode());
    }

    boolean isHome() {
        return current == HOME;
    }

    /** Leaves whatever is shown; a text begun stays as a draft. */
    void home() {
        entry.commit();
        current = HOME;
    }

    void openMenu() {
        current = new Screen.Menu(0);
    }

    void open(MessageFolder box) {
        current = new Screen.MessageList(box, 0);
    }

    /** Goes on with the draft, or begins a text. */
    void write() {
        current = writing();
    }

    void note(Note.Kind kind, String detail) {
        current = new Note(kind, detail);
    }

    boolean wantsTime() {
        return entry.isPending();
    }

    /** @return whether something changed */
    boolean timePassed(long nowNanos) {
        return entry.settle(nowNanos);
    }

    /** A character from a keyboard, while writing or entering a number. @return whether it was taken */
    boolean type(char character) {
        if (current instanceof Screen.Writing) {
            entry.type(character);
            return true;
        }
        if (current instanceof Screen.Recipient to) {
            if (character == '+' && to.number().isEmpty() || character >= '0' && character <= '9') {
                enterRecipient(to.number() + character);
            }
            return true;
        }
        return false;
    }

    /** A key, on any screen but home. */
    void press(PhoneKey key, long nowNanos) {
        if (key == PhoneKey.END) {
            home();
        } else if (current instanceof Screen.Menu menu) {
            inMenu(menu, key);
        } else if (current instanceof Screen.MessageList list) {
            inList(list, key);
        } else if (current instanceof Screen.MessageView view) {
            inMessage(view, key);
        } else if (current instanceof Screen.Writing) {
            inWriting(key, nowNanos);
        } else if (current instanceof Screen.Recipient to) {
            inRecipient(to, key);
        } else if (current() instanceof Screen.Sent sent && key == PhoneKey.OK && isFailed(sent.message())) {
            sendAgain(sent.message());
        } else if (current instanceof Screen.Sent && key == PhoneKey.OK && mailbox.unread(MessageFolder.INBOX) > 0) {
            open(MessageFolder.INBOX);
        } else {
            home();
        }
    }

    private void inMenu(Screen.Menu menu, PhoneKey key) {
        switch (key) {
            case UP -> current = new Screen.Menu((menu.selected() + MENU.length - 1) % MENU.length);
            case DOWN -> current = new Screen.Menu((menu.selected() + 1) % MENU.length);
            case OK, CALL, RIGHT -> choose(MENU[menu.selected()]);
            case LEFT, MENU -> home();
            case MESSAGE -> write();
            default ->
                key.tone()
                        .map(DtmfKey::symbol)
                        .filter(symbol -> symbol >= '1' && symbol < '1' + MENU.length)
                        .ifPresent(symbol -> choose(MENU[symbol - '1']));
        }
    }

    private void choose(MenuItem item) {
        switch (item) {
            case INBOX -> open(MessageFolder.INBOX);
            case OUTBOX -> open(MessageFolder.OUTBOX);
            case BROADCASTS -> open(MessageFolder.BROADCASTS);
            case WRITE -> write();
            case SWITCH_OFF -> {
                home();
                deeds.switchOff();
            }
        }
    }

    private void inList(Screen.MessageList list, PhoneKey key) {
        int size = mailbox.in(list.box()).size();
        switch (key) {
            case UP -> select(list, size == 0 ? 0 : (list.selected() + size - 1) % size);
            case DOWN -> select(list, size == 0 ? 0 : (list.selected() + 1) % size);
            case OK, RIGHT -> {
                if (size > 0) {
                    view(list.box(), list.selected());
                }
            }
            case CALL -> {
                if (size > 0 && list.box() != MessageFolder.BROADCASTS) {
                    callParty(message(list.box(), list.selected()));
                }
            }
            case LEFT, MENU -> openMenu();
            case MESSAGE -> write();
            default -> {}
        }
    }

    private void select(Screen.MessageList list, int selected) {
        current = new Screen.MessageList(list.box(), selected);
    }

    private void view(MessageFolder box, int selected) {
        mailbox.markRead(box, mailbox.in(box).size() - 1 - selected);
        current = new Screen.MessageView(box, selected, 0);
    }

    private StoredMessage message(MessageFolder box, int selected) {
        List<StoredMessage> messages = mailbox.in(box);
        return messages.get(messages.size() - 1 - selected);
    }

    /** A message that came while a list or message is shown moves what is selected one further from the newest. */
    void added(MessageFolder box) {
        int last = mailbox.in(box).size() - 1;
        if (current instanceof Screen.MessageView view && view.box() == box) {
            current = new Screen.MessageView(box, Math.min(last, view.selected() + 1), view.scroll());
        } else if (current instanceof Screen.MessageList list && list.box() == box && list.selected() > 0) {
            current = new Screen.MessageList(box, Math.min(last, list.selected() + 1));
        }
    }

    private void inMessage(Screen.MessageView view, PhoneKey key) {
        StoredMessage message = message(view.box(), view.selected());
        switch (key) {
            case UP -> current = new Screen.MessageView(view.box(), view.selected(), Math.max(0, view.scroll() - 1));
            case DOWN ->
                current = new Screen.MessageView(
                        view.box(), view.selected(), Math.min(lastScroll(message), view.scroll() + 1));
            case CALL -> {
                if (view.box() != MessageFolder.BROADCASTS) {
                    callParty(message);
                }
            }
            case MESSAGE, OK -> answer(view.box(), message);
            case LEFT, MENU -> current = new Screen.MessageList(view.box(), view.selected());
            case HASH -> erase(view);
            default -> {}
        }
    }

    private static int lastScroll(StoredMessage message) {
        // The narrowest display shows 16 letters a line; the view stops earlier when all is shown.
        return message.text().length() / 16
                + (int) message.text().chars().filter(c -> c == '\n').count();
    }

    private void erase(Screen.MessageView view) {
        int size = mailbox.in(view.box()).size();
        mailbox.remove(view.box(), size - 1 - view.selected());
        current = new Screen.MessageList(view.box(), Math.max(0, Math.min(size - 2, view.selected())));
    }

    private void callParty(StoredMessage message) {
        home();
        deeds.dial(message.party());
    }

    private void answer(MessageFolder box, StoredMessage message) {
        if (isFailed(message)) {
            sendAgain(message);
        } else if (box != MessageFolder.BROADCASTS) {
            recipient = isNumber(message.party()) ? message.party() : "";
            write();
        }
    }

    private static boolean isFailed(StoredMessage message) {
        return message.delivery() == Delivery.FAILED;
    }

    /** The text goes out as a new message, which takes the failed one's place. */
    private void sendAgain(StoredMessage failed) {
        if (deeds.send(Msisdn.parse(failed.party()), failed.text())) {
            mailbox.remove(MessageFolder.OUTBOX, failed);
            current = new Screen.Sent(message(MessageFolder.OUTBOX, 0));
        }
    }

    private void inWriting(PhoneKey key, long nowNanos) {
        switch (key) {
            case LEFT -> {
                if (entry.text().isEmpty()) {
                    home();
                } else {
                    entry.erase();
                }
            }
            case RIGHT -> entry.commit();
            case MENU, UP, DOWN -> entry.nextMode();
            case OK, CALL, MESSAGE -> {
                entry.commit();
                current = entry.text().isEmpty() ? current : new Screen.Recipient(recipient);
            }
            default -> key.tone().ifPresent(tone -> entry.tap(tone, nowNanos));
        }
    }

    private void inRecipient(Screen.Recipient to, PhoneKey key) {
        switch (key) {
            case LEFT -> {
                if (to.number().isEmpty()) {
                    write();
                } else {
                    enterRecipient(to.number().substring(0, to.number().length() - 1));
                }
            }
            case OK, CALL, MESSAGE -> send(to.number());
            case MENU, UP -> write();
            default ->
                key.tone()
                        .map(DtmfKey::symbol)
                        .filter(Character::isDigit)
                        .ifPresent(digit -> enterRecipient(to.number() + digit));
        }
    }

    private void enterRecipient(String number) {
        if (number.length() <= Msisdn.MAX_DIGITS + 1) {
            recipient = number;
            current = new Screen.Recipient(number);
        }
    }

    private void send(String number) {
        if (!isNumber(number)) {
            note(Note.Kind.NOT_A_NUMBER, number);
        } else if (deeds.send(Msisdn.parse(number), entry.text())) {
            current = new Screen.Sent(message(MessageFolder.OUTBOX, 0));
            entry.clear();
            recipient = "";
        }
    }

    static boolean isNumber(String text) {
        return text.matches("\\+?[0-9]{1," + Msisdn.MAX_DIGITS + "}");
    }
}
