package simgsm.modem.at.port;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.InstantSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.CallDecision;
import simgsm.modem.Modem;
import simgsm.modem.ModemOptions;
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.command.AtModem;
import simgsm.modem.at.command.ModemTerminal;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simgsm.station.StationOptions;
import simgsm.station.StationThread;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;

@Timeout(60)
class AtPortCloseTest {
    @Test
    void theEndOfAPortEndsTheConnectionsOfItsClients() throws Exception {
        Modem modem = new Modem(
                StationIdentity.ofOpenNumber(new Msisdn("5550200"), new Imei("490154203237518"), "SimGSM modem"),
                Sim.WITHOUT_KEY,
                new ModemOptions(
                        new StationOptions(SpeechCodec.Kind.A_LAW, CallAudioListener.NONE, true),
                        ModemOptions.MAX_ANSWER_AFTER_MILLIS),
                caller -> new CallDecision(true, DtmfKey.ONE),
                event -> {});
        AtModem at = new AtModem(new ModemTerminal(modem), AtProfile.PLAIN, InstantSource.system());
        try (StationThread thread = new StationThread("station", fault -> {})) {
            AtPort port = AtPort.open(
                    at, modem.station(), thread, new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            thread.start();
            try (Socket client = new Socket(InetAddress.getLoopbackAddress(), port.port())) {
                client.getOutputStream().write("ATE0\r".getBytes(StandardCharsets.US_ASCII));
                assertEquals(
                        "ATE0\r\r\nOK\r\n",
                        new String(client.getInputStream().readNBytes(11), StandardCharsets.US_ASCII));
                port.close();
                assertEquals(-1, client.getInputStream().read());
            }
        }
    }
}
