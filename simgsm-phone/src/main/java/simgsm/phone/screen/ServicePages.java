package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import simgsm.air.Msisdn;
import simgsm.phone.screen.ListPage.ListItem;
import simgsm.ss.UssdText;

/** The network's services: own number, service codes, call forwarding and call waiting, each by its code (TS 22.030). */
final class ServicePages {
    /** A condition of call forwarding. @param code of TS 22.030, annex B */
    private record Condition(String text, String code) {}

    private static final List<Condition> CONDITIONS = List.of(
            new Condition("forward.all", "21"),
            new Condition("forward.busy", "67"),
            new Condition("forward.no_reply", "61"),
            new Condition("forward.unreachable", "62"));

    private static final String ALL_CONDITIONS = "002";
    private static final String CALL_WAITING = "43";

    private final PageStack stack;
    private final ContactPages names;

    ServicePages(PageStack stack, ContactPages names) {
        this.stack = stack;
        this.names = names;
    }

    KeyIntent menu() {
        return stack.open(ListPage.menu(
                stack,
                "menu.services",
                () -> List.of(
                        ListItem.of("service.own", () -> send("*100#")),
                        ListItem.of("service.code", this::askForCode),
                        ListItem.of("service.forwarding", this::forwarding),
                        ListItem.of("service.waiting", this::callWaiting),
                        ListItem.of("service.name", () -> send("*300#")))));
    }

    private static KeyIntent send(String code) {
        return new KeyIntent.SendUssd(code);
    }

    private KeyIntent askForCode() {
        EntryPage page = new EntryPage(
                stack,
                Words.of("service.code"),
                EntryPage.Kind.CODE,
                UssdText.MAX_SEPTETS,
                "soft.send",
                ServicePages::send);
        return stack.open(page.with("*"));
    }

    private KeyIntent forwarding() {
        List<ListItem> items = new ArrayList<>();
        for (Condition condition : CONDITIONS) {
            items.add(ListItem.of(condition.text(), () -> forwarding(condition)));
        }
        items.add(ListItem.of("forward.cancel_all", () -> send("##" + ALL_CONDITIONS + "#")));
        return stack.open(ListPage.menu(stack, "service.forwarding", () -> items));
    }

    private KeyIntent forwarding(Condition condition) {
        return stack.open(ListPage.menu(
                stack,
                condition.text(),
                () -> List.of(
                        ListItem.of("service.activate", () -> askForNumber(condition)),
                        ListItem.of("service.query", () -> send("*#" + condition.code() + "#")),
                        ListItem.of("service.cancel", () -> send("##" + condition.code() + "#")))));
    }

    private KeyIntent askForNumber(Condition condition) {
        EntryPage page = new EntryPage(
                stack,
                Words.of("forward.to"),
                EntryPage.Kind.NUMBER,
                Msisdn.MAX_DIGITS + 1,
                "soft.ok",
                number -> send("**" + condition.code() + "*" + number + "#"));
        return stack.open(page.withNames(names));
    }

    private KeyIntent callWaiting() {
        return stack.open(ListPage.menu(
                stack,
                "service.waiting",
                () -> List.of(
                        ListItem.of("service.activate", () -> send("*" + CALL_WAITING + "#")),
                        ListItem.of("service.query", () -> send("*#" + CALL_WAITING + "#")),
                        ListItem.of("service.cancel", () -> send("#" + CALL_WAITING + "#")))));
    }
}
