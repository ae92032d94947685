package simgsm.center.msc.sms;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import simgsm.air.Msisdn;
import simgsm.air.ShortMessageControl;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.LinkUser;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryPort;
import simgsm.center.smsc.Destination;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.ShortMessageCenter;

/** Short messages from and to mobiles on all links. */
public final class MobileMessages implements LinkUser, DeliveryPort {
    private final Function<Msisdn, Optional<Link>> locations;
    private final UnaryOperator<Msisdn> shown;
    private final Map<Link, ShortMessageTransfers> transfers = new HashMap<>();
    private ShortMessageCenter center;

    /**
     * @param locations finds the link of an attached subscriber
     * @param shown a subscriber's number as others see it
     */
    public MobileMessages(Function<Msisdn, Optional<Link>> locations, UnaryOperator<Msisdn> shown) {
        this.locations = locations;
        this.shown = shown;
    }

    /** Sets the short message centre that delivers through this port. */
    public void serve(ShortMessageCenter shortMessages) {
        center = shortMessages;
    }

    private ShortMessageTransfers on(Link link) {
        return transfers.computeIfAbsent(link, each -> new ShortMessageTransfers(each, center));
    }

    public void receive(Link link, ShortMessageControl message) {
        on(link).receive(message);
    }

    @Override
    public boolean needsRadio(Link link) {
        return on(link).needRadio();
    }

    @Override
    public void radioLost(Link link) {
        on(link).radioLost();
    }

    @Override
    public void linkClosed(Link link) {
        transfers.remove(link);
    }

    private Optional<Link> linkOf(Destination destination) {
        return destination instanceof Destination.Number number ? locations.apply(number.number()) : Optional.empty();
    }

    @Override
    public boolean isReachable(Destination destination) {
        return linkOf(destination).isPresent();
    }

    @Override
    public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
        linkOf(envelope.destination())
                .ifPresentOrElse(
                        link -> on(link).deliver(envelope.tpdu(moreWaiting, shown), ended),
                        () -> ended.accept(DeliveryOutcome.ABSENT));
    }
}
