package simgsm.modem.at.state;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.octets.OctetString;

/** The messages on the SIM: {@value #CAPACITY} places, counted from 1. */
public final class SimMemory {
    public static final int CAPACITY = 50;

    /** The status of a message (TS 27.005, 3.1); the ordinal is its number in PDU mode. */
    public enum Status {
        RECEIVED_UNREAD("REC UNREAD"),
        RECEIVED_READ("REC READ"),
        STORED_UNSENT("STO UNSENT"),
        STORED_SENT("STO SENT");

        private final String words;

        Status(String words) {
            this.words = words;
        }

        /** As in text mode. */
        public String words() {
            return words;
        }

        public boolean isReceived() {
            return this == RECEIVED_UNREAD || this == RECEIVED_READ;
        }
    }

    /**
     * A message.
     *
     * @param tpdu DELIVER or STATUS-REPORT if received, SUBMIT if stored
     * @param order serial number of storing
     */
    public record Entry(Status status, OctetString tpdu, long order) {}

    private final Entry[] places = new Entry[CAPACITY + 1];
    private long stored;

    public SimMemory() {}

    public static boolean isPlace(int index) {
        return index >= 1 && index <= CAPACITY;
    }

    public Optional<Entry> get(int index) {
        return isPlace(index) ? Optional.ofNullable(places[index]) : Optional.empty();
    }

    public int used() {
        return (int) Arrays.stream(places).filter(entry -> entry != null).count();
    }

    public boolean isFull() {
        return used() == CAPACITY;
    }

    /** @return the place; empty if the memory is full */
    public OptionalInt add(Status status, OctetString tpdu) {
        for (int index = 1; index <= CAPACITY; index++) {
            if (places[index] == null) {
                places[index] = new Entry(status, tpdu, stored++);
                return OptionalInt.of(index);
            }
        }
        return OptionalInt.empty();
    }

    public void setStatus(int index, Status status) {
        places[index] = new Entry(status, places[index].tpdu(), places[index].order());
    }

    public void remove(int index) {
        places[index] = null;
    }

    /** Removes the message stored first. */
    public void removeOldest() {
        int oldest = 0;
        for (int index = 1; index <= CAPACITY; index++) {
            if (places[index] != null && (oldest == 0 || places[index].order() < places[oldest].order())) {
                oldest = index;
            }
        }
        remove(oldest);
    }
}
