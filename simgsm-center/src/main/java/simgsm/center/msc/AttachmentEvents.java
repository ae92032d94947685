package simgsm.center.msc;

import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.center.subscriber.Subscriber;

/** Tells the operator of coming and going, and the short message centre of coming. */
record AttachmentEvents(ExchangeListener listener, Consumer<Msisdn> available) implements Mobility.Attachments {
    @Override
    public void attached(Subscriber subscriber) {
        listener.happened(new ExchangeEvent.Attached(subscriber.number()));
        available.accept(subscriber.number());
    }

    @Override
    public void detached(Subscriber subscriber) {
        listener.happened(new ExchangeEvent.Detached(subscriber.number()));
    }
}
