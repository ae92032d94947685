package simgsm.center.msc;

import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.center.smsc.ApplicationPort;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryPort;
import simgsm.center.smsc.Destination;
import simgsm.center.smsc.Envelope;
import simgsm.center.subscriber.SubscriberRegister;

/**
 * Routes messages to mobiles or applications: to the subscriber with the number, attached or not; but an application
 * that serves exactly this number gets it while the subscriber is detached.
 */
final class DeliverySelector implements DeliveryPort {
    private final DeliveryPort mobiles;
    private final ApplicationPort applications;
    private final SubscriberRegister register;

    DeliverySelector(DeliveryPort mobiles, ApplicationPort applications, SubscriberRegister register) {
        this.mobiles = mobiles;
        this.applications = applications;
        this.register = register;
    }

    @Override
    public Msisdn called(Msisdn dialled) {
        return register.home().called(dialled);
    }

    @Override
    public boolean isServed(Msisdn number) {
        return register.isServed(number) || applications.serves(number);
    }

    @Override
    public boolean isSubscriber(Msisdn number) {
        return register.isSubscriber(number);
    }

    @Override
    public boolean isReachable(Destination destination) {
        return portOf(destination).isReachable(destination);
    }

    @Override
    public int window(Destination destination) {
        return portOf(destination).window(destination);
    }

    @Override
    public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
        portOf(envelope.destination()).deliver(envelope, moreWaiting, ended);
    }

    @Override
    public void emptied(Destination destination) {
        applications.emptied(destination);
    }

    private DeliveryPort portOf(Destination destination) {
        boolean isMobile = destination instanceof Destination.Number called
                && register.ofNumber(called.number()).isPresent()
                && (mobiles.isReachable(destination) || !applications.servesExactly(called.number()));
        return isMobile ? mobiles : applications;
    }
}
