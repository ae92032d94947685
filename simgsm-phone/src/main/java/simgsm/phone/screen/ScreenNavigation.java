package simgsm.phone.screen;

import java.util.List;
import java.util.function.Supplier;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.screen.ListPage.ListItem;
import simgsm.phone.screen.Screen.Note;
import simgsm.phone.store.CallLog;
import simgsm.phone.store.Contacts;
import simgsm.phone.store.Mailbox;
import simgsm.sim.PinLock;
import simgsm.station.context.StationEvent;

/** All screens except the home screen: the menu, its pages, and the functions of the keys on them. */
public final class ScreenNavigation {
    private static final Screen HOME = new Screen.HomeView();

    private final PageStack stack = new PageStack();
    private final UssdPage ussd;
    final ContactPages names;
    final MessagePages messages;
    final CallPages calls;
    private final ServicePages services;
    private final SettingsPages settings;
    private final PinPages pins;
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
        pins = new PinPages(stack);
        services = new ServicePages(stack, names);
        this.settings = new SettingsPages(stack, settings);
    }

    public Screen current() {
        return stack.top().map(ScreenPage::screen).orElse(HOME);
    }

    /** The functions of the keys under the display; on the home screen {@link HomeKeys} has them. */
    public SoftKeys softKeys() {
        return stack.top().map(ScreenPage::softKeys).orElse(SoftKeys.NONE);
    }

    public boolean isHome() {
        return stack.top().isEmpty();
    }

    /** Shows the home screen; an unfinished text is kept. */
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

    /** Opens the options of a call. */
    KeyIntent openCallOptions(HomeKeys.Situation now) {
        boolean hasSecond = now.waits() || now.holds();
        return stack.open(ListPage.options(stack, Words.of("soft.options"))
                .option(
                        true,
                        now.waits() ? "option.take" : now.holds() ? "option.swap" : "option.hold",
                        () -> Simple.HOLD)
                .option(hasSecond, now.waits() ? "option.reject" : "option.end_held", () -> Simple.REJECT_SECOND)
                .option(true, "option.end", () -> Simple.HANG_UP)
                .option(true, "menu.names", names::list)
                .option(true, "key.menu", this::openMenu));
    }

    private KeyIntent openAbout() {
        return stack.open(TextPage.of(stack, Words.of("menu.about"), about));
    }

    /** Asks for the code that the SIM demands. */
    public KeyIntent askForPin(PinLock.Status card) {
        return pins.ask(card);
    }

    /** The SIM has answered a code. */
    public void cardAnswered(PinLock.Result result, PinLock.Status card) {
        pins.answered(result, card);
    }

    /** Shows the equipment's identity. */
    public void showImei(String imei) {
        pins.askAgain();
        stack.open(TextPage.of(stack, Words.plain("IMEI"), () -> List.of(Words.plain(imei))));
    }

    public KeyIntent note(Note.Kind kind, String detail) {
        return stack.open(new NotePage(stack, new Note(kind, detail)));
    }

    /** What is keyed in for the SIM: a number, or a code of TS 22.030; empty on other pages. */
    public String typedForCard() {
        return stack.top().orElseThrow() instanceof EntryPage page ? page.secret() : "";
    }

    /** True while the network's answer to the user's USSD text is outstanding. */
    public boolean awaitsUssd() {
        return ussd.awaitsNetwork();
    }

    /** The user's USSD text is sent. */
    public void ussdSent(String text) {
        ussd.sent(text);
    }

    public void accept(StationEvent event, PinLock.Status card) {
        if (event instanceof StationEvent.OfUssd ofUssd) {
            ussd.accept(ofUssd);
        } else if (event instanceof StationEvent.SimStateChanged) {
            pins.ask(card);
        }
    }

    /** The text is in the outbox: shows its progress. */
    public void submitted(KeyIntent.SendText sent) {
        messages.submitted(sent);
    }

    public boolean wantsTime() {
        return stack.top().filter(ScreenPage::wantsTime).isPresent();
    }

    /** @return true if the screen changed */
    public boolean timePassed(long nowNanos) {
        return stack.top().filter(page -> page.timePassed(nowNanos)).isPresent();
    }

    /** A character from a keyboard. @return false on screens without text entry */
    public boolean type(char character) {
        return stack.top().filter(page -> page.type(character)).isPresent();
    }

    /** Erases the character before the cursor; without one, closes the page. */
    public void eraseOrBack() {
        stack.top().filter(page -> !page.erase()).ifPresent(stack::close);
    }

    /** A key, on any screen but home. */
    public KeyIntent press(PhoneKey key, long nowNanos) {
        ScreenPage page = stack.top().orElseThrow();
        if (key != PhoneKey.END) {
            return page.press(key, nowNanos);
        }
        if (page == ussd) {
            return ussd.end();
        }
        stack.home();
        return pins.askAgain();
    }
}
