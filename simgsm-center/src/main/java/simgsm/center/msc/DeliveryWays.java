package simgsm.center.msc;

import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.center.smpp.EsmeRoutes;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryPort;
import simgsm.center.smsc.Destination;
import simgsm.center.smsc.Envelope;
import simgsm.center.subscriber.SubscriberRegister;

/**
 * Chooses between the ways to mobiles and to applications. A mobile that is attached gets what is sent to its number; one
 * that is away is waited for, unless an application serves just its number.
 */
final class DeliveryWays implements DeliveryPort {
    private final MessageDelivery mobiles;
    private final EsmeRoutes applications;
    private final SubscriberRegister register;

    DeliveryWays(MessageDelivery mobiles, EsmeRoutes applications, SubscriberRegister register) {
        this.mobiles = mobiles;
        this.applications = applications;
        this.register = register;
    }

    @Override
    public boolean isServed(Msisdn number) {
        return register.isServed(number) || applications.serve(number);
    }

    @Override
    public boolean isReachable(Destination receiver) {
        return wayTo(receiver).isReachable(receiver);
    }

    @Override
    public int window(Destination receiver) {
        return wayTo(receiver).window(receiver);
    }

    @Override
    public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
        wayTo(envelope.destination()).deliver(envelope, moreWaiting, ended);
    }

    @Override
    public void emptied(Destination destination) {
        applications.emptied(destination);
    }

    private DeliveryPort wayTo(Destination receiver) {
        if (!(receiver instanceof Destination.Number number)) {
            return applications;
        }
        Msisdn called = number.number();
        if (register.ofNumber(called).isEmpty()) {
            return applications;
        }
        return !mobiles.isReachable(receiver) && applications.serveExactly(called) ? applications : mobiles;
    }
}
