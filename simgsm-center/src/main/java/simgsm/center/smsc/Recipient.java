package simgsm.center.smsc;

import simgsm.air.Msisdn;

/** Whom a message or a report is for: each has a queue of its own. */
public sealed interface Recipient {
    /** Whoever can be reached under a telephone number. */
    record Number(Msisdn number) implements Recipient {
        @Override
        public String toString() {
            return number.digits();
        }
    }

    /** An application known by its system id (SMPP 3.4, 5.2.1), whatever numbers it serves. */
    record Esme(String systemId) implements Recipient {
        @Override
        public String toString() {
            return systemId;
        }
    }
}
