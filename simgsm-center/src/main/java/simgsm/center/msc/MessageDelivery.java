package simgsm.center.msc;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryPort;
import simgsm.center.smsc.DeliveryReceipt;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.Recipient;
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
    public boolean isReachable(Recipient receiver) {
        return receiver instanceof Recipient.Number number
                && linkOf(number.number()).isPresent();
    }

    @Override
    public void deliver(Envelope envelope, boolean moreWaiting, DeliveryReceipt receipt) {
        Optional<Link> link =
                envelope.receiver() instanceof Recipient.Number number ? linkOf(number.number()) : Optional.empty();
        link.ifPresentOrElse(
                there -> there.shortMessages.deliver(envelope.tpdu(moreWaiting), receipt),
                () -> receipt.ended(DeliveryOutcome.ABSENT));
    }

    private Optional<Link> linkOf(Msisdn receiver) {
        return register.ofNumber(receiver).flatMap(mobility::locationOf);
    }
}
