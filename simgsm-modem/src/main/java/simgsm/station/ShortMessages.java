package simgsm.station;

import simgsm.air.Msisdn;
import simgsm.air.OctetString;
import simgsm.air.RejectCause;
import simgsm.air.ShortMessageControl;

final class ShortMessages {
    ShortMessages(StationParts parts, ServiceRequests services, int firstReference) {}

    ServiceRequests.User sender() {
        return new ServiceRequests.User() {
            @Override
            public void connected() {}

            @Override
            public void refused(RejectCause cause) {}

            @Override
            public void lost() {}
        };
    }

    int send(Msisdn to, String text) {
        return 0;
    }

    void powerOff() {}

    void radioLost() {}

    void linkLost() {}

    boolean isBusy() {
        return false;
    }

    void expired(StationTimer timer) {}

    void arrived(ShortMessageControl message) {}

    void broadcastArrived(OctetString page) {}
}
