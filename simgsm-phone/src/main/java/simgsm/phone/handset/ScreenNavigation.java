package simgsm.phone.handset;

import java.util.List;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.KeyIntent.Simple;
import simgsm.phone.handset.Screen.Note;
import simgsm.phone.handset.StoredMessage.Delivery;
import simgsm.station.context.StationEvent;

/** Menu, lists, messages and text entry: what each key does on every screen but home. */
final class ScreenNavigation {
    private static final Screen HOME = new Screen.Home();
    private static final MenuItem[] MENU = MenuItem.values();

    private final Mailbox mailbox;
    private final TextEntry entry = new TextEntry();
    private final UssdDialog ussd = new UssdDialog();
    private String recipient = "";
    private Screen current = HOME;

    ScreenNavigation(Mailbox mailbox) {
        this.mailbox = mailbox;
    }

    Screen current() {
        if (current instanceof Screen.Sent sent) {
            return mailbox.submitted(sent.message().id())
                    .<Screen>map(Screen.Sent::new)
                    .orElse(HOME);
        }
        return current instanceof Screen.Writing ? writing() : current;
    }

    /** Whether the network's answer to the user's USSD text is outstanding. */
    boolean awaitsUssd() {
        return ussd.awaitsNetwork();
    }

    /** The user's USSD text is sent. */
    void ussdSent(String text) {
        ussd.sent(text);
        showUssd();
    }

    void accept(StationEvent.OfUssd event) {
        if (event instanceof StationEvent.UssdReceived text) {
            ussd.received(text);
            showUssd();
        } else if (event instanceof StationEvent.UssdEnded end) {
            Optional<Note> note = ussd.ended(end);
            if (current instanceof Screen.Ussd && ussd.screen().isEmpty()) {
                show(HOME);
            }
            note.ifPresent(this::show);
        }
    }

    /** A text that was begun stays as a draft. */
    private void showUssd() {
        entry.commit();
        ussd.screen().ifPresent(this::show);
    }

    private KeyIntent inUssd(PhoneKey key) {
        switch (ussd.press(key)) {
            case SEND_REPLY -> {
                return new KeyIntent.ReplyUssd(ussd.screen().orElseThrow().reply());
            }
            case LEAVE -> {
                ussd.close();
                show(HOME);
                return Simple.END_USSD;
            }
            default -> {
                showUssd();
                return Simple.NOTHING;
            }
        }
    }

    private Screen.Writing writing() {
        return new Screen.Writing(entry.text(), entry.isPending(), entry.choices(), entry.mode());
    }

    private KeyIntent show(Screen screen) {
        current = screen;
        return Simple.NOTHING;
    }

    boolean isHome() {
        return current == HOME;
    }

    /** Shows the home screen; a text that was begun stays as a draft. */
    KeyIntent home() {
        entry.commit();
        return show(HOME);
    }

    KeyIntent openMenu() {
        return show(new Screen.Menu(0));
    }

    KeyIntent open(MessageFolder box) {
        return show(new Screen.MessageList(box, 0));
    }

    /** Continues the draft, or begins a text. */
    KeyIntent write() {
        return show(writing());
    }

    KeyIntent note(Note.Kind kind, String detail) {
        return show(new Note(kind, detail));
    }

    boolean wantsTime() {
        return entry.isPending();
    }

    /** @return whether something changed */
    boolean timePassed(long nowNanos) {
        return entry.settle(nowNanos);
    }

    /** A character from a keyboard. @return false on screens without text entry */
    boolean type(char character) {
        if (current instanceof Screen.Writing) {
            entry.type(character);
            return true;
        }
        if (current instanceof Screen.Ussd && ussd.type(character)) {
            showUssd();
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
    KeyIntent press(PhoneKey key, long nowNanos) {
        if (current instanceof Screen.Ussd) {
            return inUssd(key);
        }
        if (key == PhoneKey.END) {
            return home();
        }
        if (current instanceof Screen.Menu menu) {
            return inMenu(menu, key);
        }
        if (current instanceof Screen.MessageList list) {
            return inList(list, key);
        }
        if (current instanceof Screen.MessageView view) {
            return inMessage(view, key);
        }
        if (current instanceof Screen.Writing) {
            return inWriting(key, nowNanos);
        }
        if (current instanceof Screen.Recipient to) {
            return inRecipient(to, key);
        }
        return current() instanceof Screen.Sent sent && key == PhoneKey.OK ? afterSent(sent.message()) : home();
    }

    private KeyIntent afterSent(StoredMessage message) {
        if (isFailed(message)) {
            return sendAgain(message);
        }
        return mailbox.unread(MessageFolder.INBOX) > 0 ? open(MessageFolder.INBOX) : home();
    }

    private KeyIntent inMenu(Screen.Menu menu, PhoneKey key) {
        return switch (key) {
            case UP -> show(new Screen.Menu((menu.selected() + MENU.length - 1) % MENU.length));
            case DOWN -> show(new Screen.Menu((menu.selected() + 1) % MENU.length));
            case OK, CALL, RIGHT -> choose(MENU[menu.selected()]);
            case LEFT, MENU -> home();
            case MESSAGE -> write();
            default ->
                key.tone()
                        .map(DtmfKey::symbol)
                        .filter(symbol -> symbol >= '1' && symbol < '1' + MENU.length)
                        .map(symbol -> choose(MENU[symbol - '1']))
                        .orElse(Simple.NOTHING);
        };
    }

    private KeyIntent choose(MenuItem item) {
        return switch (item) {
            case INBOX -> open(MessageFolder.INBOX);
            case OUTBOX -> open(MessageFolder.OUTBOX);
            case BROADCASTS -> open(MessageFolder.BROADCASTS);
            case WRITE -> write();
            case SWITCH_OFF -> {
                home();
                yield Simple.SWITCH_OFF;
            }
        };
    }

    private KeyIntent inList(Screen.MessageList list, PhoneKey key) {
        int size = mailbox.in(list.box()).size();
        return switch (key) {
            case UP -> select(list, size == 0 ? 0 : (list.selected() + size - 1) % size);
            case DOWN -> select(list, size == 0 ? 0 : (list.selected() + 1) % size);
            case OK, RIGHT -> size > 0 ? view(list.box(), list.selected()) : Simple.NOTHING;
            case CALL -> size > 0 ? callParty(list.box(), message(list.box(), list.selected())) : Simple.NOTHING;
            case LEFT, MENU -> openMenu();
            case MESSAGE -> write();
            default -> Simple.NOTHING;
        };
    }

    private KeyIntent select(Screen.MessageList list, int selected) {
        return show(new Screen.MessageList(list.box(), selected));
    }

    private KeyIntent view(MessageFolder box, int selected) {
        mailbox.markRead(box, mailbox.in(box).size() - 1 - selected);
        return show(new Screen.MessageView(box, selected, 0));
    }

    private StoredMessage message(MessageFolder box, int selected) {
        List<StoredMessage> messages = mailbox.in(box);
        return messages.get(messages.size() - 1 - selected);
    }

    /** A new message in the shown folder moves the selected one further from the newest. */
    void added(MessageFolder box) {
        int last = mailbox.in(box).size() - 1;
        if (current instanceof Screen.MessageView view && view.box() == box) {
            current = new Screen.MessageView(box, Math.min(last, view.selected() + 1), view.scroll());
        } else if (current instanceof Screen.MessageList list && list.box() == box && list.selected() > 0) {
            current = new Screen.MessageList(box, Math.min(last, list.selected() + 1));
        }
    }

    private KeyIntent inMessage(Screen.MessageView view, PhoneKey key) {
        StoredMessage message = message(view.box(), view.selected());
        return switch (key) {
            case UP -> scroll(view, Math.max(0, view.scroll() - 1));
            case DOWN -> scroll(view, Math.min(lastScroll(message), view.scroll() + 1));
            case CALL -> callParty(view.box(), message);
            case MESSAGE, OK -> answer(view.box(), message);
            case LEFT, MENU -> show(new Screen.MessageList(view.box(), view.selected()));
            case HASH -> erase(view);
            default -> Simple.NOTHING;
        };
    }

    private KeyIntent scroll(Screen.MessageView view, int lines) {
        return show(new Screen.MessageView(view.box(), view.selected(), lines));
    }

    private static int lastScroll(StoredMessage message) {
        // The narrowest display shows 16 letters a line; the view stops earlier when all is shown.
        return message.text().length() / 16
                + (int) message.text().chars().filter(c -> c == '\n').count();
    }

    private KeyIntent erase(Screen.MessageView view) {
        int size = mailbox.in(view.box()).size();
        mailbox.remove(view.box(), message(view.box(), view.selected()));
        return show(new Screen.MessageList(view.box(), Math.max(0, Math.min(size - 2, view.selected()))));
    }

    /** Calls the sender or receiver of a message; a broadcast has none. */
    private KeyIntent callParty(MessageFolder box, StoredMessage message) {
        if (box == MessageFolder.BROADCASTS) {
            return Simple.NOTHING;
        }
        home();
        return new KeyIntent.DialText(message.party());
    }

    private KeyIntent answer(MessageFolder box, StoredMessage message) {
        if (isFailed(message)) {
            return sendAgain(message);
        }
        if (box == MessageFolder.BROADCASTS) {
            return Simple.NOTHING;
        }
        recipient = isNumber(message.party()) ? message.party() : "";
        return write();
    }

    private static boolean isFailed(StoredMessage message) {
        return message.delivery() == Delivery.FAILED;
    }

    private static KeyIntent sendAgain(StoredMessage failed) {
        return new KeyIntent.SendText(Msisdn.parse(failed.party()), failed.text(), Optional.of(failed));
    }

    private KeyIntent inWriting(PhoneKey key, long nowNanos) {
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
        return Simple.NOTHING;
    }

    private KeyIntent inRecipient(Screen.Recipient to, PhoneKey key) {
        String number = to.number();
        return switch (key) {
            case LEFT -> number.isEmpty() ? write() : enterRecipient(number.substring(0, number.length() - 1));
            case OK, CALL, MESSAGE -> send(number);
            case MENU, UP -> write();
            default ->
                key.tone()
                        .map(DtmfKey::symbol)
                        .filter(Character::isDigit)
                        .map(digit -> enterRecipient(number + digit))
                        .orElse(Simple.NOTHING);
        };
    }

    private KeyIntent enterRecipient(String number) {
        if (number.length() <= Msisdn.MAX_DIGITS + 1) {
            recipient = number;
            current = new Screen.Recipient(number);
        }
        return Simple.NOTHING;
    }

    private KeyIntent send(String number) {
        return isNumber(number)
                ? new KeyIntent.SendText(Msisdn.parse(number), entry.text(), Optional.empty())
                : note(Note.Kind.NOT_A_NUMBER, number);
    }

    /** The text is in the outbox: shows its progress. It takes the place of a failed message, or was the draft. */
    void submitted(KeyIntent.SendText sent) {
        sent.replaced().ifPresent(failed -> mailbox.remove(MessageFolder.OUTBOX, failed));
        current = new Screen.Sent(message(MessageFolder.OUTBOX, 0));
        if (sent.replaced().isEmpty()) {
            entry.clear();
            recipient = "";
        }
    }

    /** Whether the green key sends the typed text as a service code and does not call it (TS 22.030, 6.5.3.2). */
    static boolean isServiceCode(String text) {
        return text.endsWith("#");
    }

    static boolean isNumber(String text) {
        return text.matches("\\+?[0-9]{1," + Msisdn.MAX_DIGITS + "}");
    }
}
