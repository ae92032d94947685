package simgsm.phone.handset;

import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.sms.ChannelList;
import simgsm.station.MobileStation;
import simgsm.station.StationSnapshot;

/** What the handset asks of the mobile station inside it; called on the station's owner thread. */
public interface StationSide {
    /** @return false if nothing happens because a call is under way or the station is off */
    boolean dial(Msisdn number);

    /** @return false if no call rings */
    boolean answer();

    /** @return false if there is no call */
    boolean hangUp();

    /** Queues a key to be signalled. @param millis how long it sounds */
    void signalKey(DtmfKey key, int millis);

    /** Signals a key until {@link #letGoKey}. */
    void holdKey(DtmfKey key);

    void letGoKey();

    /** @return the message reference of the first part */
    int sendMessage(Msisdn to, String text);

    void memory(boolean isAvailable);

    void wantBroadcasts(ChannelList channels);

    void powerOn();

    void powerOff();

    StationSnapshot snapshot();

    /** The real thing. */
    static StationSide of(MobileStation station) {
        return new StationSide() {
            @Override
            public boolean dial(Msisdn number) {
                return station.dial(number);
            }

            @Override
            public boolean answer() {
                return station.answer();
            }

            @Override
            public boolean hangUp() {
                return station.hangUp();
            }

            @Override
            public void signalKey(DtmfKey key, int millis) {
                station.signalKey(key, millis);
            }

            @Override
            public void holdKey(DtmfKey key) {
                station.holdKey(key);
            }

            @Override
            public void letGoKey() {
                station.letGoKey();
            }

            @Override
            public int sendMessage(Msisdn to, String text) {
                return station.sendMessage(to, text);
            }

            @Override
            public void memory(boolean isAvailable) {
                if (isAvailable) {
                    station.memoryAvailable();
                } else {
                    station.memoryFull();
                }
            }

            @Override
            public void wantBroadcasts(ChannelList channels) {
                station.wantBroadcasts(channels);
            }

            @Override
            public void powerOn() {
                station.powerOn();
            }

            @Override
            public void powerOff() {
                station.powerOff();
            }

            @Override
            public StationSnapshot snapshot() {
                return station.snapshot();
            }
        };
    }
}
