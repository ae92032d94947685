package simgsm.center.msc.ss;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.air.SupplementaryService;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.LinkUser;
import simgsm.center.subscriber.Subscriber;

/** Supplementary services of mobiles on all links. */
public final class UssdDialogues implements LinkUser {
    private final Function<Msisdn, Optional<Link>> locations;
    private final Map<Link, LinkDialogues> dialogues = new HashMap<>();
    private final UssdServices services;
    private final ServiceProcedures procedures;

    /**
     * @param locations finds the link of an attached subscriber
     * @param language of the services' texts
     * @param callWaiting default of call waiting
     * @param store as for {@link ServiceProcedures}
     */
    public UssdDialogues(
            Function<Msisdn, Optional<Link>> locations,
            Locale language,
            boolean callWaiting,
            UserReports reports,
            BiConsumer<Subscriber, Consumer<Boolean>> store) {
        procedures = new ServiceProcedures(callWaiting, store);
        this.locations = locations;
        services = new UssdServices(this::ask, reports, language);
    }

    private LinkDialogues on(Link link) {
        return dialogues.computeIfAbsent(link, each -> new LinkDialogues(each, services::begin, procedures));
    }

    /** Handles a message of a registered mobile. */
    public void receive(Link link, SupplementaryService message) {
        on(link).receive(message);
    }

    private void ask(Msisdn number, String question, Consumer<UssdOutcome> told) {
        locations
                .apply(number)
                .ifPresentOrElse(
                        link -> on(link).ask(question, told),
                        () -> told.accept(UssdOutcome.of(UssdOutcome.Kind.ABSENT)));
    }

    @Override
    public boolean needsRadio(Link link) {
        return dialogues.containsKey(link) && on(link).needRadio();
    }

    @Override
    public void radioLost(Link link) {
        if (dialogues.containsKey(link)) {
            on(link).radioLost();
        }
    }

    @Override
    public void linkClosed(Link link) {
        LinkDialogues closed = dialogues.remove(link);
        if (closed != null) {
            closed.closed();
        }
    }
}
