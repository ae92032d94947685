package simgsm.center.bsc;

import java.util.ArrayDeque;
import java.util.Queue;
import simgsm.octets.OctetString;

/** Downlink layer 3 held during an assignment or handover, and the release after it. */
final class HeldDownlink {
    private record Message(int sapi, OctetString layer3) {}

    private final Queue<Message> messages = new ArrayDeque<>();
    private boolean hasRelease;

    void add(int sapi, OctetString layer3) {
        messages.add(new Message(sapi, layer3));
    }

    void addRelease() {
        hasRelease = true;
    }

    /**
     * Sends the messages on a channel.
     *
     * @return true if the connection is to be released afterwards
     */
    boolean sendOn(DedicatedChannel channel) {
        while (!messages.isEmpty()) {
            Message next = messages.remove();
            channel.send(next.sapi, next.layer3);
        }
        return hasRelease;
    }
}
