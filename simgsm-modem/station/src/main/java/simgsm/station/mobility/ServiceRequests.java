package simgsm.station.mobility;

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
import simgsm.station.context.StationContext;
import simgsm.station.context.StationTimer;
import simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationEvent;

/** Mobility management connections for calls and short messages: one request at a time (TS 24.008, 4.5.1). */
public final class ServiceRequests {
    /** A machine that needs a connection. */
    public interface ServiceUser {
        void connected();

        void refused(RejectCause cause);

        /** The radio connection has been lost or released. */
        void lost();
    }

    /** Most repetitions of a request that crossed a channel release. */
    private static final int MAX_REPEATS = 3;

    private final StationContext context;
    private final MobileRegistration registration;
    private final Map<ServiceType, ServiceUser> users = new EnumMap<>(ServiceType.class);
    private final Deque<ServiceType> waiting = new ArrayDeque<>();
    private final Set<ServiceType> active = EnumSet.noneOf(ServiceType.class);
    /** The request not yet answered by the network, or null. */
    private ServiceType pending;

    /** True if the user of the pending request no longer needs it. */
    private boolean pendingReleased;

    private int repeats;
    /** A pending request was released: no further request before the channel is released (TS 24.008, 4.5.1.7). */
    private boolean aborting;

    public ServiceRequests(StationContext context, MobileRegistration registration) {
        this.context = context;
        this.registration = registration;
    }

    public void setUser(ServiceType service, ServiceUser user) {
        users.put(service, user);
    }

    /** Requests a connection; its user is called when the network has answered. */
    public void request(ServiceType service) {
        if (service == pending) {
            pendingReleased = false;
        } else if (service == ServiceType.EMERGENCY_CALL) {
            waiting.remove(service);
            waiting.addFirst(service);
        } else if (!waiting.contains(service)) {
            waiting.add(service);
        }
        serve();
    }

    /** Ends a connection or withdraws the request for one. */
    public void release(ServiceType service) {
        waiting.remove(service);
        active.remove(service);
        if (service == pending) {
            pendingReleased = true;
            if (active.isEmpty()) {
                abort();
            }
        }
    }

    /** Withdraws a request; a connection of this kind is kept. */
    public void withdraw(ServiceType service) {
        waiting.remove(service);
        pendingReleased |= service == pending;
    }

    private void abort() {
        clearPending();
        if (context.radio().isOpen()) {
            aborting = true;
            context.radio().send(new CmServiceAbort());
        } else {
            serve();
        }
    }

    /** Ends a connection; a later request is kept. */
    public void complete(ServiceType service) {
        active.remove(service);
    }

    /** The network has opened this connection. */
    public void adopt(ServiceType service) {
        active.add(service);
    }

    /** True if the station is registered, or, for an emergency call, has a cell; until then requests wait. */
    public boolean isAvailable(ServiceType service) {
        return registration.isRegistered()
                || service == ServiceType.EMERGENCY_CALL && registration.permitsEmergencyCall();
    }

    /** True if the network has refused the station, so that a request would wait in vain. */
    public boolean isRefused() {
        return registration.isRefused();
    }

    private boolean isIdle() {
        return active.isEmpty() && waiting.isEmpty() && pending == null;
    }

    /**
     * Leaves an unused channel that the network does not release within T3240 (TS 24.008, 4.5.3.1).
     *
     * @param isUsed true if a call or a message needs the channel
     */
    public void superviseChannel(boolean isUsed) {
        boolean isUnused = !registration.needsRadio() && (aborting || isIdle() && !isUsed);
        if (!context.radio().isOpen() || !isUnused) {
            context.timers().stop(StationTimer.T3240);
        } else if (!context.timers().isRunning(StationTimer.T3240)) {
            context.timers().start(StationTimer.T3240, this::leaveChannel);
        }
    }

    /** Sends the next request if none is pending. */
    public void serve() {
        if (pending == null && !aborting && !waiting.isEmpty() && isAvailable(waiting.peek())) {
            pending = waiting.poll();
            pendingReleased = false;
            context.timers().start(StationTimer.T3230, () -> refused(RejectCause.NETWORK_FAILURE));
            context.radio()
                    .send(new CmServiceRequest(pending, registration.keySequence(), registration.serviceIdentity()));
        }
    }

    /** The network has accepted the request, by CM SERVICE ACCEPT or by ciphering. */
    public void accepted() {
        if (pending == null) {
            context.log().trace(Level.DEBUG, "CM SERVICE ACCEPT without a request");
            return;
        }
        ServiceType service = pending;
        boolean needed = !pendingReleased;
        clearPending();
        repeats = 0;
        if (needed) {
            active.add(service);
            users.get(service).connected();
        }
        serve();
    }

    void refused(RejectCause cause) {
        if (pending == null) {
            context.log().trace(Level.DEBUG, "CM SERVICE REJECT without a request");
            return;
        }
        ServiceType service = pending;
        boolean needed = !pendingReleased;
        clearPending();
        if (cause == RejectCause.IMSI_UNKNOWN_IN_VLR && ++repeats <= MAX_REPEATS) {
            repeat(service, needed);
            registration.fire(MobileRegistrationEvent.FORGOTTEN_BY_NETWORK);
            return;
        }
        repeats = 0;
        if (needed) {
            users.get(service).refused(cause);
        }
        serve();
    }

    /** The network has released the channel; a request that crossed the release is repeated. */
    public void channelReleased() {
        ServiceType unanswered = pending;
        boolean needed = !pendingReleased;
        aborting = false;
        clearPending();
        loseActive();
        if (unanswered != null && ++repeats <= MAX_REPEATS) {
            repeat(unanswered, needed);
        } else if (unanswered != null) {
            repeats = 0;
            users.get(unanswered).refused(RejectCause.NETWORK_FAILURE);
        }
        serve();
    }

    private void loseActive() {
        Set<ServiceType> lost = EnumSet.copyOf(active);
        active.clear();
        lost.forEach(service -> users.get(service).lost());
    }

    /** The network has ended all connections (TS 24.008, 4.3.5): no further request before the channel is released. */
    void aborted(RejectCause cause) {
        aborting = true;
        if (pending != null) {
            refused(cause);
        }
        loseActive();
    }

    private void leaveChannel() {
        context.radio().release();
        aborting = false;
        serve();
    }

    public void linkLost() {
        repeats = 0;
        aborting = false;
        waiting.clear();
        active.clear();
        clearPending();
        users.values().forEach(ServiceUser::lost);
    }

    private void repeat(ServiceType service, boolean needed) {
        if (needed) {
            waiting.addFirst(service);
        }
    }

    private void clearPending() {
        pending = null;
        pendingReleased = false;
        context.timers().stop(StationTimer.T3230);
    }
}
