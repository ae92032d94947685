package simgsm.center.smsc;

import java.util.function.Consumer;
import simgsm.air.Msisdn;

/** Delivers messages to applications. */
public interface ApplicationPort extends DeliveryPort {
    /** A centre without applications. */
    ApplicationPort NONE = new ApplicationPort() {
        @Override
        public boolean serves(Msisdn number) {
            return false;
        }

        @Override
        public boolean servesExactly(Msisdn number) {
            return false;
        }

        @Override
        public boolean isReachable(Destination destination) {
            return false;
        }

        @Override
        public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
            ended.accept(DeliveryOutcome.ABSENT);
        }
    };

    /** True if an application serves this number, alone or in a range. */
    boolean serves(Msisdn number);

    /** True if an application serves this number alone. */
    boolean servesExactly(Msisdn number);
}
