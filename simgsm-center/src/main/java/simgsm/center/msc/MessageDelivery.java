package simgsm.center.msc;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.air.OctetString;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryPort;
import simgsm.center.smsc.DeliveryReceipt;
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
    public boolean isReachable(Msisdn receiver) {
        return linkOf(receiver).isPresent();
    }

    @Override
    public void deliver(Msisdn receiver, OctetString tpdu, DeliveryReceipt receipt) {
        linkOf(receiver)
                .ifPresentOrElse(
                        link -> link.shortMessages.deliver(tpdu, receipt), () -> receipt.ended(DeliveryOutcome.ABSENT));
    }

    private Optional<Link> linkOf(Msisdn receiver) {
        return register.ofNumber(receiver).flatMap(mobility::locationOf);
    }
}
