package simgsm.center.smsc;

import simgsm.air.Msisdn;

/** The receiver of a message or report, with one queue each. Ordered: numbers first, then by text. */
public sealed interface Destination extends Comparable<Destination> {
    @Override
    default int compareTo(Destination other) {
        boolean isSameKind = getClass() == other.getClass();
        return isSameKind ? toString().compareTo(other.toString()) : this instanceof Number ? -1 : 1;
    }

    /** The mobile or application of a telephone number. */
    record Number(Msisdn number) implements Destination {
        @Override
        public String toString() {
            return number.digits();
        }
    }

    /** An application by its system id (SMPP 3.4, 5.2.1), independent of its numbers. */
    record Esme(String systemId) implements Destination {
        @Override
        public String toString() {
            return systemId;
        }
    }
}
