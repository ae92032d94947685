package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.screen.ListPage.ListItem;
import simgsm.phone.screen.Screen.Note;
import simgsm.phone.store.CallLog;
import simgsm.phone.store.CallRecord;
import simgsm.phone.store.Contacts;
import simgsm.phone.store.Mailbox;
import simgsm.phone.store.MessageFolder;
import simgsm.station.context.StationEvent;

/** Everything but the home screen: the menu, its pages, and what each key does on them. */
public final class ScreenNavigation {
    private static final Screen HOME = new Screen.HomeView();

    private final PageStack stack = new PageStack();
    private final UssdPage ussd;
    private final ContactPages names;
    private final MessagePages messages;
    private final CallPages calls;
    private final ServicePages services;
    private final SettingsPages settings;
    private final Supplier<List<Words>> about;

    /** @param about lines about the phone and its network */
    public ScreenNavigation(
            Mailbox mailbox,
            CallLog log,
            Contacts contacts,
            Supplier<UserSettings> settings,
            Supplier<List<Words>> about) {
        this.about = about;
        ussd = new UssdPage(stack, contacts::nameOf);
        names = new ContactPages(stack, contacts);
        messages = new MessagePages(stack, mailbox, contacts, names);
        names.setWriteTo(messages::writeTo);
        calls = new CallPages(stack, log, contacts, names, messages);
        services = new ServicePages(stack, names);
        this.settings = new SettingsPages(stack, settings);
    }

    public Screen current() {
        return stack.top().map(ScreenPage::screen).orElse(HOME);
    }

    /** What the keys under the display do; on the home screen they are {@link HomeKeys}'s. */
    public SoftKeys softKeys() {
        return stack.top().map(ScreenPage::softKeys).orElse(SoftKeys.NONE);
    }

    public boolean isHome() {
        return stack.top().isEmpty();
    }

    /** Shows the home screen; a text that was begun stays. */
    public KeyIntent home() {
        return stack.home();
    }

    KeyIntent openMenu() {
        return stack.open(ListPage.menu(
                stack,
                "key.menu",
                () -> List.of(
                        ListItem.of("menu.messages", messages::menu),
                        ListItem.of("menu.names", names::list),
                        ListItem.of("menu.calls", calls::menu),
                        ListItem.of("menu.services", services::menu),
                        ListItem.of("menu.settings", settings::menu),
                        ListItem.of("menu.about", this::openAbout),
                        ListItem.of("menu.switch_off", () -> {
                            stack.home();
                            return Simple.SWITCH_OFF;
                        }))));
    }

    /** What can be done in a call. */
    KeyIntent openCallOptions(HomeKeys.Situation now) {
        List<ListItem> items = new ArrayList<>();
        ListPage page = ListPage.menu(stack, "soft.options", () -> items);
        String hold = now.waits() ? "option.take" : now.holds() ? "option.swap" : "option.hold";
        items.add(page.closing(hold, () -> Simple.HOLD));
        if (now.waits() || now.holds()) {
            items.add(page.closing(now.waits() ? "option.reject" : "option.end_held", () -> Simple.REJECT_SECOND));
        }
        items.add(page.closing("option.end", () -> Simple.HANG_UP));
        items.add(page.closing("menu.names", names::list));
        items.add(page.closing("key.menu", this::openMenu));
        return stack.open(page);
    }

    private KeyIntent openAbout() {
        return stack.open(TextPage.of(stack, Words.of("menu.about"), about));
    }

    /** Shows the equipment's identity. */
    public void showImei(String imei) {
        stack.open(TextPage.of(stack, Words.plain("IMEI"), () -> List.of(Words.plain(imei))));
    }

    public KeyIntent open(MessageFolder folder) {
        return messages.open(folder);
    }

    public KeyIntent open(CallRecord.Kind kind) {
        return calls.open(kind);
    }

    public KeyIntent openNames() {
        return names.list();
    }

    /** Saves a number under a name that is keyed in. */
    public KeyIntent saveNumber(String number) {
        return names.save(number);
    }

    /** Continues the text, or begins one. */
    public KeyIntent write() {
        return messages.write();
    }

    public KeyIntent note(Note.Kind kind, String detail) {
        return stack.open(new NotePage(stack, new Note(kind, detail)));
    }

    /** Whether the network's answer to the user's USSD text is outstanding. */
    public boolean awaitsUssd() {
        return ussd.awaitsNetwork();
    }

    /** The user's USSD text is sent. */
    public void ussdSent(String text) {
        ussd.sent(text);
    }

    public void accept(StationEvent.OfUssd event) {
        ussd.accept(event);
    }

    /** The text is in the outbox: shows its progress. */
    public void submitted(KeyIntent.SendText sent) {
        messages.submitted(sent);
    }

    public boolean wantsTime() {
        return stack.top().filter(ScreenPage::wantsTime).isPresent();
    }

    /** @return whether something changed */
    public boolean timePassed(long nowNanos) {
        return stack.top().filter(page -> page.timePassed(nowNanos)).isPresent();
    }

    /** A character from a keyboard. @return false on screens without text entry */
    public boolean type(char character) {
        return stack.top().filter(page -> page.type(character)).isPresent();
    }

    /** The keyboard's key for erasing; where there is nothing to erase, it goes back. */
    public void eraseOrBack() {
        stack.top().filter(page -> !page.erase()).ifPresent(stack::close);
    }

    /** A key, on any screen but home. */
    public KeyIntent press(PhoneKey key, long nowNanos) {
        ScreenPage page = stack.top().orElseThrow();
        if (key != PhoneKey.END) {
            return page.press(key, nowNanos);
        }
        return page == ussd ? ussd.end() : stack.home();
    }
}
