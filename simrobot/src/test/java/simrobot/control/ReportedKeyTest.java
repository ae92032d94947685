package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.AnsweringModem;
import simgsm.modem.ModemEvent;
import simgsm.station.StationSnapshot;
import simgsm.station.context.StationEvent;
import simrobot.simulation.Simulation;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/** The latency of an order that a real modem reports key by key. */
class ReportedKeyTest {
    private Consumer<StationEvent> listener;

    private final class Silent implements AnsweringModem {
        @Override
        public StationSnapshot snapshot() {
            throw new AssertionError();
        }

        @Override
        public boolean sendTone(DtmfKey key) {
            return true;
        }

        @Override
        public int reply(Msisdn to, String text) {
            return 0;
        }

        @Override
        public void setOrderUnderWay(boolean active) {}

        @Override
        public boolean hangUp() {
            return false;
        }
    }

    /** @param tickMillis since the last count of speech when the key is reported */
    @ParameterizedTest
    @CsvSource({"0, 160", "6, 160", "14, 37", "20, 37", "60, 0"})
    void aReportedKeyBeganItsDurationBeforeItsReport(int tickMillis, int keyMillis) {
        ControlThreads threads = new ControlThreads(Runnable::run, Runnable::run, () -> 0);
        ModemLink<Silent> link = new ModemLink<>(
                (admission, events) -> {
                    listener = events;
                    return new Silent();
                },
                threads);
        VeriCommandSettings settings =
                new VeriCommandSettings(Locale.ENGLISH, Set.of(), VeriCommandSettings.OnHangup.STOP);
        link.serve(new RobotControl(new Simulation(World.bare(), 1).addRobot("robot"), settings, link, () -> 0));
        listener.accept(new ModemEvent.SpeechProcessed(8000));
        DtmfDigit reported = DtmfDigit.reported(DtmfKey.ONE, 8000 + 8L * tickMillis, OptionalInt.of(keyMillis));
        assertEquals(8L * keyMillis, link.samplesSinceStart(reported));
    }
}
