package simgsm.center.msc;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryPort;
import simgsm.center.smsc.Destination;
import simgsm.center.smsc.Envelope;
import simgsm.center.subscriber.SubscriberRegister;

/** The short message centre's way to attached mobiles. */
final class MessageDelivery implements DeliveryPort {
    private final SubscriberRegister register;
    private Mobility mobility;

    MessageDelivery(SubscriberRegister register) {
        this.register = register;
    }

    /** Mobility knows the short message centre, which knows this port; so the last arrow is drawn afterwards. */
    void locations(Mobility whereabouts) {
        mobility = whereabouts;
    }

    @Override
    public boolean isReachable(Destination receiver) {
        return receiver instanceof Destination.Number number
                && linkOf(number.number()).isPresent();
    }

    @Override
    public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
        Optional<Link> link = envelope.destination() instanceof Destination.Number number
                ? linkOf(number.number())
                : Optional.empty();
        link.ifPresentOrElse(
                there -> there.shortMessages.deliver(envelope.tpdu(moreWaiting), ended),
                () -> ended.accept(DeliveryOutcome.ABSENT));
    }

    private Optional<Link> linkOf(Msisdn receiver) {
        return register.ofNumber(receiver).flatMap(mobility::locationOf);
    }
}
