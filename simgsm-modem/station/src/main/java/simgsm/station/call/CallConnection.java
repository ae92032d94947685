package simgsm.station.call;

import simgsm.air.MobilityManagement.ServiceType;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationTimer;
import simgsm.station.mobility.ServiceRequests;

/**
 * A call's mobility management connection. A dialled call waits for it until the network serves the mobile, as after power
 * on; an emergency call needs a cell only.
 */
final class CallConnection {
    private final StationContext context;
    private final ServiceRequests services;
    private final Runnable refused;
    private ServiceType service = ServiceType.MOBILE_ORIGINATED_CALL;

    /** @param refused runs when the wait ends without service */
    CallConnection(StationContext context, ServiceRequests services, Runnable refused) {
        this.context = context;
        this.services = services;
        this.refused = refused;
    }

    /** Sets the service for the next call. */
    void use(ServiceType next) {
        service = next;
    }

    boolean isEmergency() {
        return service == ServiceType.EMERGENCY_CALL;
    }

    void request() {
        services.request(service);
    }

    void adopt() {
        services.adopt(service);
    }

    void release() {
        services.release(service);
    }

    /** Begins the wait, unless there is service. */
    void begin() {
        if (!services.isAvailable(service)) {
            context.timers().start(StationTimer.CALL_WAIT, refused);
            check();
        }
    }

    /** Ends the wait once there is service, or registration was refused. */
    void check() {
        if (isRunning() && services.isAvailable(service)) {
            context.timers().stop(StationTimer.CALL_WAIT);
            services.serve();
        } else if (isRunning() && !isEmergency() && services.isRefused()) {
            refused.run();
        }
    }

    /** The call ends and another is held, which needs the connection. */
    void withdraw() {
        services.withdraw(service);
    }

    boolean isRunning() {
        return context.timers().isRunning(StationTimer.CALL_WAIT);
    }
}
