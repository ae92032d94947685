package simgsm.station.call;

import simgsm.station.context.StationContext;
import simgsm.station.context.StationTimer;
import simgsm.station.mobility.ServiceRequests;

/** Delays a dialled call until the network serves the mobile, as after it is switched on. */
final class ServiceWait {
    private final StationContext context;
    private final ServiceRequests services;
    private final Runnable refused;

    /** @param refused runs when the wait ends without service */
    ServiceWait(StationContext context, ServiceRequests services, Runnable refused) {
        this.context = context;
        this.services = services;
        this.refused = refused;
    }

    /** Begins the wait, unless there is service. */
    void begin() {
        if (!services.isAvailable()) {
            context.timers().start(StationTimer.CALL_WAIT, refused);
            check();
        }
    }

    /** Ends the wait once registration has succeeded or was refused. */
    void check() {
        if (isRunning() && services.isAvailable()) {
            context.timers().stop(StationTimer.CALL_WAIT);
        } else if (isRunning() && services.isRefused()) {
            refused.run();
        }
    }

    boolean isRunning() {
        return context.timers().isRunning(StationTimer.CALL_WAIT);
    }
}
