package simgsm.center.smsc;

import simgsm.air.Msisdn;

/** The receiver of a message or report; each has a queue of its own. Ordered: numbers first, then by text. */
public sealed interface Destination extends Comparable<Destination> {
    @Override
    default int compareTo(Destination other) {
        boolean isSameKind = getClass() == other.getClass();
        return isSameKind ? toString().compareTo(other.toString()) : this instanceof Number ? -1 : 1;
    }

    /** The mobile or application that a telephone number reaches. */
    record Number(Msisdn number) implements Destination {
        @Override
        public String toString() {
            return number.digits();
        }
    }

    /** An application by its system id (SMPP 3.4, 5.2.1), independent of the numbers that it serves. */
    record Esme(String systemId) implements Destination {
        @Override
        public String toString() {
            return systemId;
        }
    }
}
