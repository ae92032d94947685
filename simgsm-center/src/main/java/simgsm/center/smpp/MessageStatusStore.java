package simgsm.center.smpp;

import java.time.Instant;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;

/** What became of the messages of applications, for those who ask. The oldest that have ended are forgotten. */
final class MessageStatusStore {
    static final int MAX_ENDED = 100_000;

    /** @param at when it ended; when it was taken, while it is under way */
    record Fate(String systemId, String source, Msisdn to, MessageState state, Instant at) {}

    private final Map<Long, Fate> underWay = new HashMap<>();
    private final Map<Long, Fate> ended = new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Long, Fate> eldest) {
            return size() > MAX_ENDED;
        }
    };

    void changed(ShortMessage message, MessageState state, Instant now) {
        message.esme().ifPresent(origin -> {
            Fate fate = new Fate(origin.systemId(), origin.source().value(), message.to(), state, now);
            if (state == MessageState.ACCEPTED) {
                underWay.put(message.id(), fate);
            } else {
                underWay.remove(message.id());
                ended.put(message.id(), fate);
            }
        });
    }

    /** The message with this id if this application sent it from this address; an empty address fits every message. */
    Optional<Fate> find(String id, String systemId, String source) {
        long number;
        try {
            number = Long.parseLong(id);
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
        return Optional.ofNullable(underWay.getOrDefault(number, ended.get(number)))
                .filter(fate -> fate.systemId.equals(systemId))
                .filter(fate -> source.isEmpty() || withoutPlus(source).equals(fate.source));
    }

    private static String withoutPlus(String address) {
        return address.startsWith("+") ? address.substring(1) : address;
    }
}
