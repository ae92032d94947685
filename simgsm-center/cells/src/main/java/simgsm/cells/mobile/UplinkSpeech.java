package simgsm.cells.mobile;

import simgsm.abis.RtpPacket;
import simgsm.air.ProtocolViolation;
import simgsm.speech.SpeechCodec;

/** Makes GSM 06.10 of a terminal's speech, which may be A-law: a traffic channel carries nothing else. */
final class UplinkSpeech {
    private SpeechCodec decoder = SpeechCodec.Kind.A_LAW.open();
    private SpeechCodec encoder = SpeechCodec.Kind.GSM_FULL_RATE.open();

    /** A new call. */
    void restart() {
        decoder = SpeechCodec.Kind.A_LAW.open();
        encoder = SpeechCodec.Kind.GSM_FULL_RATE.open();
    }

    /** The packet with GSM 06.10; the same octets if it has that already. */
    byte[] convert(byte[] rtp) throws ProtocolViolation {
        RtpPacket packet = RtpPacket.decode(rtp);
        if (packet.payloadType() == RtpPacket.GSM_FULL_RATE) {
            return rtp;
        }
        return new RtpPacket(
                        RtpPacket.GSM_FULL_RATE,
                        packet.sequence(),
                        packet.timestamp(),
                        packet.source(),
                        encoder.encode(decoder.decode(packet.payload())))
                .encode();
    }
}
