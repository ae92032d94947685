package simgsm.station.call;

import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationTimer;
import simgsm.station.mobility.ServiceRequests;

/**
 * A call's mobility management connection. A dialled call waits for it until the network serves the mobile, as after power
 * on; an emergency call needs a cell only.
 */
final class CallConnection {
    private static final int TRANSACTIONS = 7;

    private final StationContext context;
    private final ServiceRequests services;
    private final Runnable refused;
    private int nextTransaction;
    private boolean hidesNumber;
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

    void hideNumber(boolean hides) {
        hidesNumber = hides;
    }

    /** A transaction identifier that the second call does not use. */
    TransactionIdentifier freeTransaction(SecondCall second) {
        TransactionIdentifier free = new TransactionIdentifier(nextTransaction, false);
        nextTransaction = (nextTransaction + 1) % TRANSACTIONS;
        return second.has(free.answered()) ? freeTransaction(second) : free;
    }

    /** The first message of the dialled call. */
    CallControl setup(TransactionIdentifier transaction, Optional<Msisdn> called) {
        return isEmergency()
                ? new CallControl.EmergencySetup(transaction)
                : new CallControl.Setup(
                        transaction, Optional.empty(), Optional.empty(), called, Optional.empty(), hidesNumber);
    }

    private boolean isEmergency() {
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
