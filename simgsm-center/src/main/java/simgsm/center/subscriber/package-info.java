/**
 * The registers: who belongs to the network (HLR) and how each one is known while it visits (VLR). Read
 * {@link simgsm.center.subscriber.HomeRegister},
 * then {@link simgsm.center.subscriber.SubscriberRegister}.
 */
package simgsm.center.subscriber;
