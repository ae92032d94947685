package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import simgsm.air.MobilityManagement.CmServiceAbort;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.RejectCause;

/**
 * Mobility management connections: calls and short messages ask here for the radio, one request at a time (TS 24.008,
 * 4.5.1).
 */
final class ServiceRequests {
    /** Who uses the radio. */
    interface User {
        void connected();

        void refused(RejectCause cause);

        /** The radio connection has gone. */
        void lost();
    }

    /** A request that a channel release has crossed is repeated so often. */
    private static final int MOST_REPEATS = 3;

    private final StationParts parts;
    private final MobileRegistration registration;
    private final Map<ServiceType, User> users = new EnumMap<>(ServiceType.class);
    private final Deque<ServiceType> waiting = new ArrayDeque<>();
    private final Set<ServiceType> active = EnumSet.noneOf(ServiceType.class);
    /** The request that the network has not answered yet, or null. */
    private ServiceType asked;

    private boolean askedInVain;
    private int repeats;
    /** We have let go of an unanswered request; nothing is asked until the channel is released (TS 24.008, 4.5.1.7). */
    private boolean aborting;

    ServiceRequests(StationParts parts, MobileRegistration registration) {
        this.parts = parts;
        this.registration = registration;
    }

    void setUser(ServiceType service, User user) {
        users.put(service, user);
    }

    /** Asks for a connection; the user hears when it is there. */
    void request(ServiceType service) {
        if (service == asked) {
            askedInVain = false;
        } else if (!waiting.contains(service)) {
            waiting.add(service);
        }
        serve();
    }

    /** The user wants no connection any more, or has done with it. */
    void release(ServiceType service) {
        waiting.remove(service);
        active.remove(service);
        if (service == asked) {
            askedInVain = true;
            if (active.isEmpty()) {
                abort();
            }
        }
    }

    private void abort() {
        stopAsking();
        if (parts.radio().isOpen()) {
            aborting = true;
            parts.radio().send(new CmServiceAbort());
        } else {
            serve();
        }
    }

    /** The user has done with its connection; one that it has asked for since is still wanted. */
    void done(ServiceType service) {
        active.remove(service);
    }

    /** The network has opened a connection of its own accord. */
    void adopt(ServiceType service) {
        active.add(service);
    }

    /** Whether there is service; without it requests wait. */
    boolean isThere() {
        return registration.isRegistered();
    }

    /** Whether waiting for service is in vain, because the network does not want this station. */
    boolean isRefused() {
        return registration.isRefused();
    }

    boolean isIdle() {
        return active.isEmpty() && waiting.isEmpty() && asked == null;
    }

    /** Whether nobody uses the channel and the network is to release it, whatever waits for the next. */
    boolean isAborting() {
        return aborting;
    }

    /** Sends the next request, if the network may be asked now. */
    void serve() {
        if (registration.isRegistered() && asked == null && !aborting && !waiting.isEmpty()) {
            asked = waiting.poll();
            askedInVain = false;
            parts.timers().start(StationTimer.T3230);
            parts.radio().send(new CmServiceRequest(asked, registration.keySequence(), registration.identity()));
        }
    }

    void accepted() {
        if (asked == null) {
            parts.log().trace(Level.DEBUG, "CM SERVICE ACCEPT without a request");
            return;
        }
        ServiceType service = asked;
        boolean wanted = !askedInVain;
        stopAsking();
        repeats = 0;
        if (wanted) {
            active.add(service);
            users.get(service).connected();
        }
        serve();
    }

    void refused(RejectCause cause) {
        if (asked == null) {
            parts.log().trace(Level.DEBUG, "CM SERVICE REJECT without a request");
            return;
        }
        ServiceType service = asked;
        boolean wanted = !askedInVain;
        stopAsking();
        if (cause == RejectCause.IMSI_UNKNOWN_IN_VLR && ++repeats <= MOST_REPEATS) {
            repeat(service, wanted);
            registration.forgottenByNetwork();
            return;
        }
        repeats = 0;
        if (wanted) {
            users.get(service).refused(cause);
        }
        serve();
    }

    void t3230Expired() {
        refused(RejectCause.NETWORK_FAILURE);
    }

    /** The network has released the channel; a request that it had not read yet is made anew. */
    void channelReleased() {
        ServiceType unanswered = asked;
        boolean wanted = !askedInVain;
        aborting = false;
        stopAsking();
        loseActive();
        if (unanswered != null && ++repeats <= MOST_REPEATS) {
            repeat(unanswered, wanted);
        } else if (unanswered != null) {
            repeats = 0;
            users.get(unanswered).refused(RejectCause.NETWORK_FAILURE);
        }
        serve();
    }

    /** We have left a channel that the network did not release. */
    void channelLeft() {
        aborting = false;
        serve();
    }

    void linkLost() {
        repeats = 0;
        aborting = false;
        Set<ServiceType> all = EnumSet.copyOf(users.keySet());
        waiting.clear();
        active.clear();
        stopAsking();
        all.forEach(service -> users.get(service).lost());
    }

    private void repeat(ServiceType service, boolean wanted) {
        if (wanted) {
            waiting.addFirst(service);
        }
    }

    private void loseActive() {
        Set<ServiceType> lost = EnumSet.copyOf(active);
        active.clear();
        lost.forEach(service -> users.get(service).lost());
    }

    private void stopAsking() {
        asked = null;
        askedInVain = false;
        parts.timers().stop(StationTimer.T3230);
    }
}
