package simrobot.control;

import vericommand.ReplyTone;

/** Requests of a robot's control to its modem; callable on any thread. */
interface ModemPort {
    /** @param call number of the call in which the tone is sent; the tone is dropped if that call has ended */
    void sendTone(long call, ReplyTone tone);

    /** Clears this call, and no later one, after the tones requested so far have been sent. */
    void clearCall(long call);

    /** @return false if {@code to} is not a valid number for a short message */
    boolean sendMessage(String to, String text);

    /** While an order is being executed, the modem's idle timer is paused. */
    void setOrderUnderWay(boolean underWay);
}
